/* SPDX-FileCopyrightText: The Nephoscope authors */
/* SPDX-License-Identifier: BSD-3-Clause */
/* Preloaded by ranks.py into each rank: counts what the rank gives to MPI, by MPI's own profiling interface (PMPI). */
#include <mpi.h>

static double counts[4]; /* bytes and number of messages sent; bytes and number of collective results received */

void nephoscope_mpi_counts(double* out)
{
  for (int i = 0; i < 4; ++i)
    out[i] = counts[i];
}

static void Count(int kind, double number, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  counts[kind] += number * size;
  counts[kind + 1] += 1;
}

static double Sum(const int* numbers, MPI_Comm comm)
{
  double sum = 0;
  int ranks = 0;
  PMPI_Comm_size(comm, &ranks);
  for (int i = 0; i < ranks; ++i)
    sum += numbers[i];
  return sum;
}

#define RETURN(kind, number, type, call) do { Count(kind, number, type); return call; } while (0)
#define SEND(name) int MPI_##name(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) { RETURN(0, n, t, PMPI_##name(b, n, t, to, tag, c)); }
#define ISEND(name) int MPI_##name(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r) { RETURN(0, n, t, PMPI_##name(b, n, t, to, tag, c, r)); }
SEND(Send) SEND(Ssend) SEND(Bsend) SEND(Rsend)
ISEND(Isend) ISEND(Issend) ISEND(Ibsend) ISEND(Irsend)

int MPI_Sendrecv(const void* b, int n, MPI_Datatype t, int to, int tag, void* rb, int rn, MPI_Datatype rt, int from, int rtag, MPI_Comm c, MPI_Status* s)
{ RETURN(0, n, t, PMPI_Sendrecv(b, n, t, to, tag, rb, rn, rt, from, rtag, c, s)); }
int MPI_Bcast(void* b, int n, MPI_Datatype t, int root, MPI_Comm c)
{ RETURN(2, n, t, PMPI_Bcast(b, n, t, root, c)); }
int MPI_Allreduce(const void* b, void* rb, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c)
{ RETURN(2, n, t, PMPI_Allreduce(b, rb, n, t, o, c)); }
int MPI_Allgather(const void* b, int n, MPI_Datatype t, void* rb, int rn, MPI_Datatype rt, MPI_Comm c)
{ int ranks = 0; PMPI_Comm_size(c, &ranks); RETURN(2, (double)rn * ranks, rt, PMPI_Allgather(b, n, t, rb, rn, rt, c)); }
int MPI_Allgatherv(const void* b, int n, MPI_Datatype t, void* rb, const int* rn, const int* at, MPI_Datatype rt, MPI_Comm c)
{ RETURN(2, Sum(rn, c), rt, PMPI_Allgatherv(b, n, t, rb, rn, at, rt, c)); }
/* To one rank: all that the others send to it is a message of theirs. */
int MPI_Gather(const void* b, int n, MPI_Datatype t, void* rb, int rn, MPI_Datatype rt, int root, MPI_Comm c)
{ RETURN(0, n, t, PMPI_Gather(b, n, t, rb, rn, rt, root, c)); }
int MPI_Gatherv(const void* b, int n, MPI_Datatype t, void* rb, const int* rn, const int* at, MPI_Datatype rt, int root, MPI_Comm c)
{ RETURN(0, n, t, PMPI_Gatherv(b, n, t, rb, rn, at, rt, root, c)); }
int MPI_Reduce(const void* b, void* rb, int n, MPI_Datatype t, MPI_Op o, int root, MPI_Comm c)
{ RETURN(0, n, t, PMPI_Reduce(b, rb, n, t, o, root, c)); }
