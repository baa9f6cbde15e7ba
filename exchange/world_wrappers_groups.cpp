// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file world_wrappers_groups.cpp
/// The wrappers of collective calls, topologies, windows and files; see
/// world_wrappers.cpp.
#include "exchange/world_wrappers.h"

using clay::confined;

// ---- collective calls

CLAY_WRAP(Barrier, (MPI_Comm c), (confined(c)))
CLAY_WRAP(Ibarrier, (MPI_Comm c, MPI_Request* request), (confined(c), request))

CLAY_WRAP_BOTH(Bcast, Ibcast, (void* buf, int n, MPI_Datatype type, int root, MPI_Comm c),
               (buf, n, type, root, confined(c)))
CLAY_WRAP_BOTH(Reduce, Ireduce,
               (const void* out, void* in, int n, MPI_Datatype type, MPI_Op op, int root,
                MPI_Comm c),
               (out, in, n, type, op, root, confined(c)))
CLAY_WRAP_BOTH(Reduce_scatter, Ireduce_scatter,
               (const void* out, void* in, const int n[], MPI_Datatype type, MPI_Op op, MPI_Comm c),
               (out, in, n, type, op, confined(c)))

#define CLAY_REDUCE(name, twin)                                                                \
  CLAY_WRAP_BOTH(name, twin,                                                                   \
                 (const void* out, void* in, int n, MPI_Datatype type, MPI_Op op, MPI_Comm c), \
                 (out, in, n, type, op, confined(c)))
CLAY_REDUCE(Allreduce, Iallreduce)
CLAY_REDUCE(Scan, Iscan)
CLAY_REDUCE(Exscan, Iexscan)
CLAY_REDUCE(Reduce_scatter_block, Ireduce_scatter_block)

#define CLAY_ROOTED(name, twin)                                                       \
  CLAY_WRAP_BOTH(name, twin,                                                          \
                 (const void* out, int nOut, MPI_Datatype outType, void* in, int nIn, \
                  MPI_Datatype inType, int root, MPI_Comm c),                         \
                 (out, nOut, outType, in, nIn, inType, root, confined(c)))
CLAY_ROOTED(Gather, Igather)
CLAY_ROOTED(Scatter, Iscatter)
CLAY_WRAP_BOTH(Gatherv, Igatherv,
               (const void* out, int nOut, MPI_Datatype outType, void* in, const int nIn[],
                const int at[], MPI_Datatype inType, int root, MPI_Comm c),
               (out, nOut, outType, in, nIn, at, inType, root, confined(c)))
CLAY_WRAP_BOTH(Scatterv, Iscatterv,
               (const void* out, const int nOut[], const int at[], MPI_Datatype outType, void* in,
                int nIn, MPI_Datatype inType, int root, MPI_Comm c),
               (out, nOut, at, outType, in, nIn, inType, root, confined(c)))

// from all to all, or among the neighbours of a topology
#define CLAY_ALL(name, twin)                                                          \
  CLAY_WRAP_BOTH(name, twin,                                                          \
                 (const void* out, int nOut, MPI_Datatype outType, void* in, int nIn, \
                  MPI_Datatype inType, MPI_Comm c),                                   \
                 (out, nOut, outType, in, nIn, inType, confined(c)))
#define CLAY_ALL_GATHERV(name, twin)                                                          \
  CLAY_WRAP_BOTH(name, twin,                                                                  \
                 (const void* out, int nOut, MPI_Datatype outType, void* in, const int nIn[], \
                  const int at[], MPI_Datatype inType, MPI_Comm c),                           \
                 (out, nOut, outType, in, nIn, at, inType, confined(c)))
#define CLAY_ALL_V(name, twin, Place, Types)                                                      \
  CLAY_WRAP_BOTH(name, twin,                                                                      \
                 (const void* out, const int nOut[], const Place* outAt, Types outType, void* in, \
                  const int nIn[], const Place* inAt, Types inType, MPI_Comm c),                  \
                 (out, nOut, outAt, outType, in, nIn, inAt, inType, confined(c)))
CLAY_ALL(Allgather, Iallgather)
CLAY_ALL(Alltoall, Ialltoall)
CLAY_ALL(Neighbor_allgather, Ineighbor_allgather)
CLAY_ALL(Neighbor_alltoall, Ineighbor_alltoall)
CLAY_ALL_GATHERV(Allgatherv, Iallgatherv)
CLAY_ALL_GATHERV(Neighbor_allgatherv, Ineighbor_allgatherv)
CLAY_ALL_V(Alltoallv, Ialltoallv, int, MPI_Datatype)
CLAY_ALL_V(Neighbor_alltoallv, Ineighbor_alltoallv, int, MPI_Datatype)
CLAY_ALL_V(Alltoallw, Ialltoallw, int, const MPI_Datatype*)
CLAY_ALL_V(Neighbor_alltoallw, Ineighbor_alltoallw, MPI_Aint, const MPI_Datatype*)

// ---- topologies

CLAY_WRAP(Topo_test, (MPI_Comm c, int* status), (confined(c), status))
CLAY_WRAP(Cart_create,
          (MPI_Comm c, int n, const int dims[], const int periods[], int reorder, MPI_Comm* made),
          (confined(c), n, dims, periods, reorder, made))
CLAY_WRAP(Cart_get, (MPI_Comm c, int n, int dims[], int periods[], int coords[]),
          (confined(c), n, dims, periods, coords))
CLAY_WRAP(Cart_rank, (MPI_Comm c, const int coords[], int* rank), (confined(c), coords, rank))
CLAY_WRAP(Cart_coords, (MPI_Comm c, int rank, int n, int coords[]), (confined(c), rank, n, coords))
CLAY_WRAP(Cart_shift, (MPI_Comm c, int direction, int by, int* from, int* to),
          (confined(c), direction, by, from, to))
CLAY_WRAP(Cart_sub, (MPI_Comm c, const int keep[], MPI_Comm* made), (confined(c), keep, made))
CLAY_WRAP(Cart_map, (MPI_Comm c, int n, const int dims[], const int periods[], int* rank),
          (confined(c), n, dims, periods, rank))
CLAY_WRAP(Cartdim_get, (MPI_Comm c, int* n), (confined(c), n))
CLAY_WRAP(Graph_create,
          (MPI_Comm c, int n, const int index[], const int edges[], int reorder, MPI_Comm* made),
          (confined(c), n, index, edges, reorder, made))
CLAY_WRAP(Graph_get, (MPI_Comm c, int n, int m, int index[], int edges[]),
          (confined(c), n, m, index, edges))
CLAY_WRAP(Graph_map, (MPI_Comm c, int n, const int index[], const int edges[], int* rank),
          (confined(c), n, index, edges, rank))
CLAY_WRAP(Graph_neighbors_count, (MPI_Comm c, int rank, int* n), (confined(c), rank, n))
CLAY_WRAP(Graph_neighbors, (MPI_Comm c, int rank, int n, int neighbours[]),
          (confined(c), rank, n, neighbours))
CLAY_WRAP(Graphdims_get, (MPI_Comm c, int* nodes, int* edges), (confined(c), nodes, edges))
CLAY_WRAP(Dist_graph_create,
          (MPI_Comm c, int n, const int nodes[], const int degrees[], const int targets[],
           const int weights[], MPI_Info info, int reorder, MPI_Comm* made),
          (confined(c), n, nodes, degrees, targets, weights, info, reorder, made))
CLAY_WRAP(Dist_graph_create_adjacent,
          (MPI_Comm c, int nIn, const int in[], const int inWeights[], int nOut, const int out[],
           const int outWeights[], MPI_Info info, int reorder, MPI_Comm* made),
          (confined(c), nIn, in, inWeights, nOut, out, outWeights, info, reorder, made))
CLAY_WRAP(Dist_graph_neighbors,
          (MPI_Comm c, int nIn, int in[], int inWeights[], int nOut, int out[], int outWeights[]),
          (confined(c), nIn, in, inWeights, nOut, out, outWeights))
CLAY_WRAP(Dist_graph_neighbors_count, (MPI_Comm c, int* in, int* out, int* weighted),
          (confined(c), in, out, weighted))

// ---- windows and files

CLAY_WRAP(Win_create,
          (void* base, MPI_Aint size, int unit, MPI_Info info, MPI_Comm c, MPI_Win* win),
          (base, size, unit, info, confined(c), win))
CLAY_WRAP(Win_allocate,
          (MPI_Aint size, int unit, MPI_Info info, MPI_Comm c, void* base, MPI_Win* win),
          (size, unit, info, confined(c), base, win))
CLAY_WRAP(Win_allocate_shared,
          (MPI_Aint size, int unit, MPI_Info info, MPI_Comm c, void* base, MPI_Win* win),
          (size, unit, info, confined(c), base, win))
CLAY_WRAP(Win_create_dynamic, (MPI_Info info, MPI_Comm c, MPI_Win* win), (info, confined(c), win))
CLAY_WRAP(File_open, (MPI_Comm c, const char* name, int mode, MPI_Info info, MPI_File* file),
          (confined(c), name, mode, info, file))
