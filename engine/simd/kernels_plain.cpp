#include "engine/simd/crowding_kernel.h"
#include "engine/simd/fit_kernel.h"
#include "engine/simd/product_kernels.h"
#include "engine/simd/search_kernel.h"

namespace rouleau::simd {

const Kernels plain_kernels{
    collect,           find_pairs,      distances, fit,      divergences,    velocity_laplacians,
    velocity_products, field_gradients, gradients, crowding, matrix_products};

}  // namespace rouleau::simd
