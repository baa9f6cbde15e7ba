// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file world_wrappers.cpp
/// MPI's profiling interface confines a host code to its half: each call that
/// takes a communicator means the half where the host says MPI_COMM_WORLD. Here:
/// start and end, messages, communicators; see also world_wrappers_groups.cpp.
#include "exchange/shutdown.h"
#include "exchange/start_watch.h"
#include "exchange/world_wrappers.h"

using clay::confined;

// ---- start and end

extern "C" int MPI_Init(int* argc, char*** argv) {
  const clay::StartWatch watch;
  const int status = PMPI_Init(argc, argv);
  clay::World::instance().split(clay::programHalf);
  return status;
}

extern "C" int MPI_Init_thread(int* argc, char*** argv, int required, int* provided) {
  const clay::StartWatch watch;
  const int status = PMPI_Init_thread(argc, argv, required, provided);
  clay::World::instance().split(clay::programHalf);
  return status;
}

extern "C" int MPI_Finalize() {
  clay::beforeFinalize();
  clay::World::instance().giveBack();
  return PMPI_Finalize();
}

extern "C" int MPI_Abort(MPI_Comm, int code) { clay::abortBoth(code); }

// ---- messages

#define CLAY_SEND(name)                                                                     \
  CLAY_WRAP(name, (const void* buf, int n, MPI_Datatype type, int to, int tag, MPI_Comm c), \
            (buf, n, type, to, tag, confined(c)))
#define CLAY_SEND_REQUEST(name)                                                      \
  CLAY_WRAP(name,                                                                    \
            (const void* buf, int n, MPI_Datatype type, int to, int tag, MPI_Comm c, \
             MPI_Request* request),                                                  \
            (buf, n, type, to, tag, confined(c), request))
#define CLAY_RECEIVE_REQUEST(name)                                                                \
  CLAY_WRAP(                                                                                      \
      name,                                                                                       \
      (void* buf, int n, MPI_Datatype type, int from, int tag, MPI_Comm c, MPI_Request* request), \
      (buf, n, type, from, tag, confined(c), request))

CLAY_SEND(Send)
CLAY_SEND(Ssend)
CLAY_SEND(Rsend)
CLAY_SEND(Bsend)
CLAY_SEND_REQUEST(Isend)
CLAY_SEND_REQUEST(Issend)
CLAY_SEND_REQUEST(Irsend)
CLAY_SEND_REQUEST(Ibsend)
CLAY_SEND_REQUEST(Send_init)
CLAY_SEND_REQUEST(Ssend_init)
CLAY_SEND_REQUEST(Rsend_init)
CLAY_SEND_REQUEST(Bsend_init)
CLAY_RECEIVE_REQUEST(Irecv)
CLAY_RECEIVE_REQUEST(Recv_init)

CLAY_WRAP(Recv, (void* buf, int n, MPI_Datatype type, int from, int tag, MPI_Comm c, MPI_Status* s),
          (buf, n, type, from, tag, confined(c), s))
CLAY_WRAP(Sendrecv,
          (const void* out, int nOut, MPI_Datatype outType, int to, int outTag, void* in, int nIn,
           MPI_Datatype inType, int from, int inTag, MPI_Comm c, MPI_Status* s),
          (out, nOut, outType, to, outTag, in, nIn, inType, from, inTag, confined(c), s))
CLAY_WRAP(Sendrecv_replace,
          (void* buf, int n, MPI_Datatype type, int to, int outTag, int from, int inTag, MPI_Comm c,
           MPI_Status* s),
          (buf, n, type, to, outTag, from, inTag, confined(c), s))
CLAY_WRAP(Probe, (int from, int tag, MPI_Comm c, MPI_Status* s), (from, tag, confined(c), s))
CLAY_WRAP(Iprobe, (int from, int tag, MPI_Comm c, int* flag, MPI_Status* s),
          (from, tag, confined(c), flag, s))
CLAY_WRAP(Mprobe, (int from, int tag, MPI_Comm c, MPI_Message* m, MPI_Status* s),
          (from, tag, confined(c), m, s))
CLAY_WRAP(Improbe, (int from, int tag, MPI_Comm c, int* flag, MPI_Message* m, MPI_Status* s),
          (from, tag, confined(c), flag, m, s))
CLAY_WRAP(Pack,
          (const void* in, int n, MPI_Datatype type, void* out, int size, int* at, MPI_Comm c),
          (in, n, type, out, size, at, confined(c)))
CLAY_WRAP(Unpack,
          (const void* in, int size, int* at, void* out, int n, MPI_Datatype type, MPI_Comm c),
          (in, size, at, out, n, type, confined(c)))
CLAY_WRAP(Pack_size, (int n, MPI_Datatype type, MPI_Comm c, int* size),
          (n, type, confined(c), size))

// ---- communicators

CLAY_WRAP(Comm_rank, (MPI_Comm c, int* rank), (confined(c), rank))
CLAY_WRAP(Comm_size, (MPI_Comm c, int* size), (confined(c), size))
CLAY_WRAP(Comm_group, (MPI_Comm c, MPI_Group* group), (confined(c), group))
CLAY_WRAP(Comm_compare, (MPI_Comm a, MPI_Comm b, int* result), (confined(a), confined(b), result))
CLAY_WRAP(Comm_create, (MPI_Comm c, MPI_Group group, MPI_Comm* made), (confined(c), group, made))
CLAY_WRAP(Comm_create_group, (MPI_Comm c, MPI_Group group, int tag, MPI_Comm* made),
          (confined(c), group, tag, made))
CLAY_WRAP(Comm_dup, (MPI_Comm c, MPI_Comm* made), (confined(c), made))
CLAY_WRAP(Comm_idup, (MPI_Comm c, MPI_Comm* made, MPI_Request* r), (confined(c), made, r))
CLAY_WRAP(Comm_dup_with_info, (MPI_Comm c, MPI_Info info, MPI_Comm* made),
          (confined(c), info, made))
CLAY_WRAP(Comm_split, (MPI_Comm c, int colour, int key, MPI_Comm* made),
          (confined(c), colour, key, made))
CLAY_WRAP(Comm_split_type, (MPI_Comm c, int type, int key, MPI_Info info, MPI_Comm* made),
          (confined(c), type, key, info, made))
CLAY_WRAP(Comm_test_inter, (MPI_Comm c, int* flag), (confined(c), flag))
CLAY_WRAP(Comm_remote_size, (MPI_Comm c, int* size), (confined(c), size))
CLAY_WRAP(Comm_remote_group, (MPI_Comm c, MPI_Group* group), (confined(c), group))
CLAY_WRAP(Intercomm_create,
          (MPI_Comm local, int leader, MPI_Comm bridge, int remote, int tag, MPI_Comm* made),
          (confined(local), leader, confined(bridge), remote, tag, made))
CLAY_WRAP(Intercomm_merge, (MPI_Comm c, int high, MPI_Comm* made), (confined(c), high, made))
CLAY_WRAP(Comm_get_name, (MPI_Comm c, char* name, int* length), (confined(c), name, length))
CLAY_WRAP(Comm_set_name, (MPI_Comm c, const char* name), (confined(c), name))
CLAY_WRAP(Comm_get_info, (MPI_Comm c, MPI_Info* info), (confined(c), info))
CLAY_WRAP(Comm_set_info, (MPI_Comm c, MPI_Info info), (confined(c), info))
CLAY_WRAP(Comm_get_errhandler, (MPI_Comm c, MPI_Errhandler* h), (confined(c), h))
CLAY_WRAP(Comm_set_errhandler, (MPI_Comm c, MPI_Errhandler h), (confined(c), h))
CLAY_WRAP(Comm_call_errhandler, (MPI_Comm c, int code), (confined(c), code))
CLAY_WRAP(Comm_set_attr, (MPI_Comm c, int key, void* value), (confined(c), key, value))
CLAY_WRAP(Comm_delete_attr, (MPI_Comm c, int key), (confined(c), key))

// what MPI itself attaches, it attaches to the true MPI_COMM_WORLD alone
extern "C" int MPI_Comm_get_attr(MPI_Comm c, int key, void* value, int* flag) {
  for (int own : {MPI_TAG_UB, MPI_HOST, MPI_IO, MPI_WTIME_IS_GLOBAL, MPI_APPNUM, MPI_LASTUSEDCODE,
                  MPI_UNIVERSE_SIZE})
    if (key == own) return PMPI_Comm_get_attr(c, key, value, flag);
  return PMPI_Comm_get_attr(confined(c), key, value, flag);
}

// a handle that Fortran code will use
extern "C" MPI_Fint MPI_Comm_c2f(MPI_Comm c) { return PMPI_Comm_c2f(confined(c)); }
