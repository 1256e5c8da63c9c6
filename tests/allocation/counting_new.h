#pragma once

/// A program that links this counts what it allocates.

long allocations();
long allocated_bytes();
