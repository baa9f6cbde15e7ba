// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/shared.h"

#include "exchange/decode.h"
#include "exchange/waiting.h"
#include "exchange/wire.h"
#include "exchange/world.h"

namespace clay {

void SharedParticles::clear() {
  all_.clear();
  for (auto& p : partners_) p.second.particles.clear();
}

void SharedParticles::add(const double* list, std::size_t length, int first) {
  const int me = World::instance().rank();
  for (const double* end = list + length; list < end;) {
    const int particle = first + static_cast<int>(*list++);
    all_.push_back(particle);
    for (int n = static_cast<int>(*list++); n > 0; --n) {
      const int rank = static_cast<int>(*list++);
      if (rank != me) partners_[rank].particles.push_back(particle);
    }
  }
}

// Sends the values of the particles shared with each partner; takes in theirs
void SharedParticles::swap(const std::vector<double>& values, int stride) {
  const auto& world = World::instance();
  requests_.clear();
  for (auto& [rank, p] : partners_) {
    if (p.particles.empty()) continue;
    const std::size_t n = p.particles.size() * static_cast<std::size_t>(stride);
    p.out.clear();
    for (int i : p.particles)
      for (int c = 0; c < stride; ++c)
        p.out.push_back(values[static_cast<std::size_t>(i) * stride + c]);
    p.out.push_back(wire::seal(p.out.data(), n));
    p.in.resize(n + 1);
    const int partner = world.localRanks()[static_cast<std::size_t>(rank)];
    MPI_Request request;
    PMPI_Irecv(p.in.data(), static_cast<int>(n + 1), MPI_DOUBLE, partner, wire::tagShared,
               world.whole(), &request);
    requests_.push_back(request);
    PMPI_Isend(p.out.data(), static_cast<int>(n + 1), MPI_DOUBLE, partner, wire::tagShared,
               world.whole(), &request);
    requests_.push_back(request);
  }
  statuses_.resize(requests_.size());
  waitUntil(
      [&] {
        int done = 0;
        PMPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done, statuses_.data());
        return done != 0;
      },
      "this half's values of shared particles");
  // a receive and a send each
  auto status = statuses_.begin();
  for (const auto& [rank, p] : partners_) {
    if (p.particles.empty()) continue;
    int doubles = 0;
    PMPI_Get_count(&*status, MPI_DOUBLE, &doubles);
    status += 2;
    try {
      wire::checkShared(p.in.data(), doubles, p.in.size() - 1);
    } catch (const wire::Damaged& damage) {
      abandon("the values of particles that CFD rank " + std::to_string(rank) +
              " shares with this one: " + damage.what());
    }
  }
}

void SharedParticles::sum(std::vector<double>& values, int stride) {
  if (all_.empty()) return;
  swap(values, stride);
  const int me = World::instance().rank();
  std::vector<double> own;
  own.reserve(all_.size() * static_cast<std::size_t>(stride));
  for (int i : all_)
    for (int c = 0; c < stride; ++c) {
      double& v = values[static_cast<std::size_t>(i) * stride + c];
      own.push_back(v);
      v = 0;
    }
  const auto add = [&](const std::vector<int>& particles, const std::vector<double>& part) {
    const double* from = part.data();
    for (int i : particles)
      for (int c = 0; c < stride; ++c) values[static_cast<std::size_t>(i) * stride + c] += *from++;
  };
  bool mineAdded = false;
  for (const auto& [rank, p] : partners_) {
    if (rank > me && !mineAdded) {
      add(all_, own);
      mineAdded = true;
    }
    if (!p.particles.empty()) add(p.particles, p.in);
  }
  if (!mineAdded) add(all_, own);
}

std::vector<char> SharedParticles::own(const std::vector<double>& claims) {
  constexpr double none = 1e299;
  std::vector<char> owned(claims.size());
  for (std::size_t i = 0; i < claims.size(); ++i) owned[i] = claims[i] <= none;
  if (all_.empty()) return owned;
  swap(claims, 1);
  const int me = World::instance().rank();
  for (const auto& [rank, p] : partners_)
    for (std::size_t k = 0; k < p.particles.size(); ++k) {
      const auto i = static_cast<std::size_t>(p.particles[k]);
      const double theirs = p.in[k], mine = claims[i];
      if (theirs < mine || (theirs == mine && rank < me)) owned[i] = 0;
    }
  return owned;
}

}  // namespace clay
