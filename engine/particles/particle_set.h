#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace rouleau::particles {

/// What a particle is to the solver. The order is the order in the arrays, so that a particle's group is
/// known from its index: those before `outlet` are solved for, those before `inlet` carry pressure, those
/// before `ghost` carry a velocity.
enum class Group : std::uint8_t { membrane, fluid, outlet, inlet, wall, ghost, dead };

/// All particles as a structure of arrays, in the simulation's own units. Arrays have one entry a particle.
struct ParticleSet {
  std::vector<double> x, y;        ///< position
  std::vector<double> u, v;        ///< velocity
  std::vector<double> p;           ///< pressure over density
  std::vector<double> du, dv;      ///< last change of velocity by viscosity: the next solve starts from it
  std::vector<double> phi;         ///< last pressure increment, likewise
  std::vector<std::int32_t> cell;  ///< cell it belongs to, -1: plasma and walls
  std::vector<std::int64_t> id;    ///< one number for its whole life
  std::vector<Group> group;

  int size() const { return static_cast<int>(x.size()); }

  /// Index of the first particle of a group; `first(Group::dead)` is the number of particles. Valid after
  /// a ParticleSorter was there and until particles are added or change group.
  int first(Group g) const { return first_[static_cast<std::size_t>(g)]; }
  int membrane_end() const { return first(Group::fluid); }
  int active_end() const { return first(Group::outlet); }
  int pressure_end() const { return first(Group::inlet); }
  int inlet_end() const { return first(Group::wall); }
  int velocity_end() const { return first(Group::ghost); }

  /// Adds a particle at rest with a new id; returns its index.
  int add(Group g, double px, double py, int of_cell = -1);
  /// Adds particle i of another set as it is, with its id.
  void add_from(const ParticleSet& other, int i);

  /// All that sorting does not find again, for a checkpoint.
  template <class Stream>
  friend void visit(Stream& stream, ParticleSet& set) {
    stream(set.x, set.y, set.u, set.v, set.p, set.du, set.dv, set.phi, set.cell, set.id, set.group,
           set.next_id_);
  }

  /// Ids go on where those of another set end.
  void continue_ids(const ParticleSet& before) { next_id_ = before.next_id_; }

 private:
  friend class ParticleSorter;

  std::array<int, 8> first_{};
  std::int64_t next_id_ = 0;
};

/// Puts the particles into the order of their groups, the fluid within its group by bins of the given
/// width, and drops the dead (see ParticleSorter).
void sort_particles(ParticleSet& particles, double bin);

}  // namespace rouleau::particles
