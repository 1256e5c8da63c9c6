#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"

namespace {

long allocations = 0;

void* allocate(std::size_t size, std::size_t alignment = 0) {
  ++allocations;
  void* const memory = alignment == 0
                           ? std::malloc(size == 0 ? 1 : size)
                           : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// All of this program's.
void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new[](std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace rouleau {
namespace {

Case plasma(Profile profile) {
  Case scene;
  scene.vessel = {15e-6, 10e-6};
  scene.inflow.profile = profile;
  scene.numerics.spacing = 0.8e-6;
  scene.duration = 1;
  return scene;
}

class Plasma : public testing::TestWithParam<Profile> {};

TEST_P(Plasma, StepsAllocateNothingOnceEveryArrayHasItsSize) {
  Simulation simulation(plasma(GetParam()));
  // The fluid has passed through the vessel, so the numbers of particles and pairs have been what they can
  // be.
  for (int k = 0; k < 250; ++k) simulation.step();
  const long before = allocations;
  for (int k = 0; k < 50; ++k) simulation.step();
  EXPECT_EQ(allocations - before, 0);
  EXPECT_GT(before, 0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, Plasma, testing::Values(Profile::plug, Profile::parabolic));

}  // namespace
}  // namespace rouleau
