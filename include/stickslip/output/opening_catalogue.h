// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_opening_catalogue_h
#define stickslip_output_opening_catalogue_h

#include <stickslip/output/catalogue.h>
#include <stickslip/output/node_positions.h>

#include <limits>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * One opening of one fault.
   */
  struct Opening
  {
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    std::string fault;

    /** Times, s, the second one that of the largest gap; an opening that never
     * closed closes at NaN. */
    double opens     = nan;
    double peak_time = nan;
    double closes    = nan;

    /** Largest gap of any node, m, and largest open area, m^(dim-1), after any
     * step of the opening. */
    double largest_gap       = 0;
    double largest_open_area = 0;

    /** Reference positions, m, as NodePositions has them, of the node whose gap
     * is the largest when the opening begins, and of the one with the largest
     * gap of all. */
    std::vector<double> begins_at, widest_at;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &fault &opens &peak_time &closes &largest_gap &largest_open_area
        &begins_at &widest_at;
    }
  };

  /**
   * The last step as one fault took part in it, and its opening, if that goes
   * on.
   */
  struct OpeningMemory
  {
    using Entry = Opening;

    bool    has_past    = false;
    double  time        = 0;
    double  largest_gap = 0;
    bool    is_open     = false;
    Opening entry;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &has_past &time &largest_gap &is_open &entry;
    }
  };

  /**
   * Finds the openings of faults in a sequence of accepted steps and writes
   * openings.csv, a row for each opening as soon as it has closed.
   *
   * An opening begins when the largest gap of a fault rises above a threshold
   * and ends when it falls below half of that, so that bounces of less than
   * this is no opening of its own. Both times are interpolated between the
   * steps, linearly in the largest gap.
   *
   * Columns are the members of Opening, with one for each number of the two
   * positions: begins_x, _y, _z and _arc_length, as far as they are there, and
   * widest_x and so on. Faults that may not open have no openings.
   */
  template <int dim>
  class OpeningCatalogue : public Catalogue<dim, OpeningMemory>
  {
  public:
    /** Threshold in place of none, over the extent of a fault. */
    static constexpr double default_threshold = 1e-8;

    /**
     * @p shapes: one entry a fault. @p threshold in m; 0: default_threshold
     * times the diagonal of the box around the nodes of each fault. Throws
     * InputError if the file cannot be written.
     */
    OpeningCatalogue(const std::string                   &file_name,
                     const std::vector<FaultLayout<dim>> &shapes,
                     const double                         threshold);

    TableColumns
    columns() const override;

  private:
    void
    take_in(const unsigned int        number,
            const double              time,
            const FaultSnapshot<dim> &fault) override;

    void
    fill_row(TableFile &row, const Opening &opening) const override;

    const NodePositions<dim> positions;
    /** Threshold of each fault, m. */
    std::vector<double> thresholds;
  };
} // namespace StickSlip

#endif
