#pragma once

#include "engine/error/simulation_error.h"
