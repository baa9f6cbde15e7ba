// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file test_damage.cpp
/// Stands between the test halves and MPI: damages one message on its way, as the
/// environment's TEST_DAMAGE says: "HALF TAG NUMBER WAY [A [B]]", the NUMBER-th message of
/// that tag, counted from 0, that the first rank of that half sends to the first rank of
/// the other one, or, with HALF in small letters, to another rank of its own.
#include <dlfcn.h>
#include <mpi.h>

#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "exchange/decode.h"
#include "exchange/world.h"

namespace {

using Isend = int (*)(const void*, int, MPI_Datatype, int, int, MPI_Comm, MPI_Request*);

Isend real() {
  static const auto send = reinterpret_cast<Isend>(dlsym(RTLD_NEXT, "PMPI_Isend"));
  return send;
}

struct Damage {
  std::string half, way;
  int tag = 0, number = 0;
  double a = 0, b = 0;
};

const Damage* wanted() {
  static const char* text = std::getenv("TEST_DAMAGE");
  static Damage d;
  static const bool read = [] {
    if (!text) return false;
    std::istringstream is(text);
    is >> d.half >> d.tag >> d.number >> d.way;
    std::string a, b;
    is >> a >> b;
    d.a = std::strtod(a.c_str(), nullptr);
    d.b = std::strtod(b.c_str(), nullptr);
    return true;
  }();
  return read ? &d : nullptr;
}

// Is it this message's turn
bool due(const Damage& d, int tag, int to) {
  static int seen = 0;
  const auto& world = clay::World::instance();
  if (!world.ready() || world.rank() != 0 || tag != d.tag) return false;
  const bool dem = world.which() == clay::Half::dem;
  const bool within = d.half == "dem" || d.half == "cfd";
  if (dem != (d.half == "DEM" || d.half == "dem")) return false;
  if (to != (within ? world.localRanks().back() : world.remoteRanks()[0])) return false;
  return seen++ == d.number;
}

}  // namespace

extern "C" int PMPI_Isend(const void* data, int n, MPI_Datatype type, int to, int tag, MPI_Comm c,
                          MPI_Request* request) {
  const Damage* d = wanted();
  if (!d || c != MPI_COMM_WORLD || !due(*d, tag, to))
    return real()(data, n, type, to, tag, c, request);
  int size = 1;
  PMPI_Type_size(type, &size);
  // kept: the message may be under way for long
  auto* bytes = new std::vector<char>(static_cast<const char*>(data),
                                      static_cast<const char*>(data) + n * size);
  const auto place = static_cast<std::size_t>(d->a < 0 ? d->a + static_cast<double>(n) : d->a);
  if (d->way == "word" || d->way == "sealedWord") std::memcpy(&(*bytes)[8 * place], &d->b, 8);
  if (d->way == "sealedWord") {
    const double seal =
        clay::wire::seal(reinterpret_cast<double*>(bytes->data()), static_cast<std::size_t>(n) - 1);
    std::memcpy(&(*bytes)[8 * static_cast<std::size_t>(n - 1)], &seal, 8);
  }
  if (d->way == "byte") (*bytes)[place % bytes->size()] ^= 1;
  if (d->way == "length")
    bytes->resize(
        static_cast<std::size_t>(d->a <= 0 ? std::max(0., static_cast<double>(bytes->size()) + d->a)
                                           : static_cast<double>(bytes->size()) + d->a));
  if (d->way == "lost") {
    *request = MPI_REQUEST_NULL;
    return MPI_SUCCESS;
  }
  if (d->way == "twice") real()(data, n, type, to, tag, c, new MPI_Request);
  return real()(bytes->data(), static_cast<int>(bytes->size()), MPI_BYTE, to,
                d->way == "tag" ? static_cast<int>(d->a) : tag, c, request);
}
