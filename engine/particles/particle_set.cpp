#include "engine/particles/particle_set.h"

namespace rouleau::particles {

int ParticleSet::add(Group g, double px, double py, int of_cell) {
  x.push_back(px);
  y.push_back(py);
  for (auto* field : {&u, &v, &p, &du, &dv, &phi}) field->push_back(0);
  cell.push_back(of_cell);
  id.push_back(next_id_++);
  group.push_back(g);
  return size() - 1;
}

void ParticleSet::add_from(const ParticleSet& other, int i) {
  for (auto field : {&ParticleSet::x, &ParticleSet::y, &ParticleSet::u, &ParticleSet::v, &ParticleSet::p,
                     &ParticleSet::du, &ParticleSet::dv, &ParticleSet::phi}) {
    (this->*field).push_back((other.*field)[i]);
  }
  cell.push_back(other.cell[i]);
  id.push_back(other.id[i]);
  group.push_back(other.group[i]);
}

}  // namespace rouleau::particles
