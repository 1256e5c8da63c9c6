#pragma once

namespace rouleau::service {

/// service/openapi.json, compiled in.
const char* openapi_text();

}  // namespace rouleau::service
