// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_fault_snapshot_h
#define stickslip_output_fault_snapshot_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <limits>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * State of the contact at a node that may open, in the numbers in
   * which it is written. Nodes off contact count as open.
   */
  enum class ContactState : char
  {
    open     = 0,
    slipping = 1,
    stuck    = 2,
    bonded   = 3
  };

  /**
   * The fields of one fault at one time, node by node: those of each body's
   * part of the slave side in the order of x (then y, then z). Tangential
   * vectors have dim-1 components along the axes of the nodes; slip, slip rate
   * and shear traction are those of the second side (of a stack, the upper
   * body) relative to the first one, whichever is the slave. Off-contact nodes
   * have weight zero.
   */
  template <int dim>
  struct FaultSnapshot
  {
    std::string name;

    /** Reference positions of the slave nodes, m. */
    std::vector<Point<dim>> points;

    /** Integral of the nodes' dual basis functions, m^(dim-1). */
    std::vector<double> weights;

    /** Accumulated slip, m, and its rate, m/s. */
    std::vector<Tensor<1, dim - 1>> slip;
    std::vector<Tensor<1, dim - 1>> slip_rate;

    /** Shear traction by which the fault resists the slip of the second side,
     * Pa: has the sign of the slip rate. */
    std::vector<Tensor<1, dim - 1>> shear_traction;

    /** Normal stress, Pa, compression positive. */
    std::vector<double> normal_stress;

    /** State theta, s. */
    std::vector<double> state;

    /** The force that keeps the sides together over the area, Pa; empty if
     * nobody asks for it. */
    std::vector<double> contact_pressure;

    /** Gap between the sides, m, exactly zero where they touch and at nodes off
     * contact, and its rate, m/s; empty where the fault may not open. */
    std::vector<double> gap, opening_rate;

    /** One where the sides are bonded, else zero; ordered and empty like gap.
     */
    std::vector<char> is_bonded;

    /** State of contact; empty unless it is written. */
    std::vector<ContactState> contact_state;

    /** Positions at this time, m; empty unless they are written. */
    std::vector<Point<dim>> positions;

    /** Largest gap between the sides so far, m, where they follow a fault that
     * bends and may not open; NaN elsewhere. */
    double largest_gap = std::numeric_limits<double>::quiet_NaN();

    /** True if the sides may part. */
    bool
    may_open() const
    {
      return !gap.empty();
    }

    /** Members that change from step to step, but for those which are there
     * only where they are written, to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &weights &slip &slip_rate &shear_traction &normal_stress &state
        &contact_pressure &gap &opening_rate &is_bonded &largest_gap;
    }
  };

  /**
   * Counts and times of one accepted step.
   */
  struct StepRecord
  {
    unsigned int step                  = 0;
    double       time                  = 0;
    double       step_size             = 0;
    unsigned int rate_state_iterations = 0;
    unsigned int tnnmg_iterations      = 0;
    unsigned int multigrid_cycles      = 0;
    /** As estimated (StepError). */
    double fault_error = 0, body_error = 0;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &step &time &step_size &rate_state_iterations &tnnmg_iterations
        &multigrid_cycles &fault_error &body_error;
    }
  };
} // namespace StickSlip

#endif
