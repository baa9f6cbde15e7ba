/* ----------------------------------------------------------------------
   This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef LMP_CELL_INDEX_H
#define LMP_CELL_INDEX_H

namespace clay {

/// The cell of 0 to cells - 1 that a place lies in, in units of a cell. What lies before
/// the first or behind the last belongs to these; NaN to the first: a cast of its own
/// would be undefined.
inline int cell_index(double place, int cells)
{
  if (!(place > 0)) return 0;
  return place < cells ? static_cast<int>(place) : cells - 1;
}

/// A whole number as an int, those beyond 2^30 as that; NaN as 0.
inline int cell_number(double whole)
{
  const double most = 1 << 30;
  if (!(whole > -most)) return whole < 0 ? -(1 << 30) : 0;
  return whole < most ? static_cast<int>(whole) : 1 << 30;
}

}  // namespace clay

#endif
