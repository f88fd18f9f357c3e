// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_fault_friction_h
#define stickslip_friction_fault_friction_h

#include <deal.II/base/tensor.h>

#include <stickslip/friction/friction_law.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>

#include <array>
#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The friction of all faults, as a functional of the jumps of velocity at
   * the slave nodes:
   *
   *   phi(v) = sum_p w_p (sigma_n,p Phi_p(|v_t,p|; alpha_p)
   *                       + 1/2 eta_p |v_t,p|^2),
   *
   * in W (per metre of thickness in two dimensions), where w_p is the integral
   * of the slave basis function (m^(d-1)), sigma_n the normal stress (Pa,
   * compression positive), Phi the potential of the friction law, and eta a
   * linear damping (Pa s/m), zero unless it is set. Its
   * negative gradient is the frictional force on the slave side.
   *
   * The first d - 1 components of a node are tangential, the last one is
   * normal to the fault and has no friction; a single component is tangential,
   * that out of the plane. Where a fault may open, it has a
   * bound: the sides may part, at most the gap between them closes.
   *
   * Nodes of different faults may have different laws; the class knows nothing
   * of what the laws are. No function of the NonsmoothFunctional interface
   * allocates memory.
   */
  template <int n_components>
  class FaultFriction : public NonsmoothFunctional<n_components>
  {
  public:
    /**
     * Constructor. All vectors but @p laws have one entry per friction node.
     *
     * @param nodes Local indices of the nodes, ascending.
     * @param weights Integrals w_p of the slave basis functions, positive.
     * @param normal_stresses See set_normal_stresses().
     * @param laws The laws that occur, for instance one for each fault.
     * @param law_indices For each node, the position of its law in @p laws.
     *
     * The state is alpha = 0 (theta = 1 s) until set_state() is called.
     */
    FaultFriction(const std::vector<unsigned int> &nodes,
                  const std::vector<double>       &weights,
                  const std::vector<double>       &normal_stresses,
                  const std::vector<std::shared_ptr<const FrictionLaw>> &laws,
                  const std::vector<unsigned int> &law_indices);

    /**
     * Set alpha = ln(theta / 1 s) at each node.
     */
    void
    set_state(const std::vector<double> &alpha);

    /**
     * Set the normal stress at each node, Pa. Throws unless all are finite and
     * none is negative: a fault under tension has no friction law.
     */
    void
    set_normal_stresses(const std::vector<double> &normal_stresses);

    /**
     * Set the linear damping eta at each node, Pa s/m, none negative.
     */
    void
    set_damping(const std::vector<double> &damping);

    /**
     * Say which nodes may open. @p signs: for each node the sign, 1 or -1, that
     * the normal component has when the fault opens; 0 for nodes at which it
     * has no bound, which is so everywhere without this call. To be called on
     * all processes or on none. The bounds are zero until they are set.
     */
    void
    set_opening(const std::vector<int> &signs);

    /**
     * Set the least rate of opening, the normal component times the sign of
     * set_opening(), at each node, m/s; zero where the sides touch. Not looked
     * at where the sign is zero.
     */
    void
    set_opening_bounds(const std::vector<double> &bounds);

    /**
     * Set the cohesion at each node, Pa, none negative: a shear traction in
     * addition to that of friction which does not depend on the slip rate.
     */
    void
    set_cohesion(const std::vector<double> &cohesion);

    /**
     * The law at term @p k.
     */
    const FrictionLaw &
    law(const unsigned int k) const
    {
      AssertIndexRange(k, terms.size());
      return *terms[k].law;
    }

    /**
     * The data of the law at term @p k, FrictionLaw::node_data() of its state;
     * ln(Vmin) for rate-and-state friction.
     */
    double
    law_data(const unsigned int k) const
    {
      AssertIndexRange(k, terms.size());
      return terms[k].data;
    }

    /**
     * The slip rate |v_t| of a node's jump of velocity, m/s.
     */
    static double
    slip_rate(const Tensor<1, n_components> &v);

    const std::vector<unsigned int> &
    nodes() const override
    {
      return node_indices;
    }

    /** True after set_opening(). */
    bool
    has_bounds() const override;

    Tensor<1, n_components>
    project(const unsigned int             k,
            const Tensor<1, n_components> &v) const override;

    bool
    is_at_bound(const unsigned int             k,
                const Tensor<1, n_components> &v,
                const unsigned int             component) const override;

    double
    value(const unsigned int             k,
          const Tensor<1, n_components> &v) const override;

    double
    directional_derivative(
      const unsigned int             k,
      const Tensor<1, n_components> &v,
      const Tensor<1, n_components> &direction) const override;

    Tensor<1, n_components>
    gradient(const unsigned int             k,
             const Tensor<1, n_components> &v) const override;

    /**
     * Phi'' t t^T + Phi'/V (I - t t^T) on the tangential part, where
     * t = v_t / V, times w_p sigma_n, and w_p eta. Entries beyond 1e200 are set
     * to that value, which keeps products with zero out of trouble.
     */
    Tensor<2, n_components>
    hessian(const unsigned int             k,
            const Tensor<1, n_components> &v) const override;

    /**
     * The chord of the law in the direction of slip (FrictionLaw::chord()),
     * for the change of the coefficient that takes up the tangential force in
     * that direction; across it the same as hessian().
     */
    Tensor<2, n_components>
    secant_hessian(const unsigned int             k,
                   const Tensor<1, n_components> &v,
                   const Tensor<1, n_components> &force) const override;

    bool
    is_smooth(const unsigned int             k,
              const Tensor<1, n_components> &v) const override;

    bool
    acts_on(const unsigned int k, const unsigned int component) const override;

    /**
     * Eliminates the normal component, if it is active, and solves for the
     * tangential ones with the functions of local_problem.h. If the normal
     * component is then beyond its bound, the minimiser has it there, since the
     * problem is convex, and the tangential ones are solved for once more.
     */
    Tensor<1, n_components>
    minimise(const unsigned int                    k,
             const Tensor<2, n_components>        &A,
             const Tensor<1, n_components>        &r,
             const std::array<bool, n_components> &active,
             const Tensor<1, n_components>        &start) const override;

  private:
    /**
     * Numbers that the functions of one node need, side by side.
     */
    struct Term
    {
      const FrictionLaw *law;
      /** FrictionLaw::node_data(). */
      double data;
      /** w_p sigma_n,p. */
      double load;
      /** w_p eta_p. */
      double damping;
      /** w_p times the cohesion. */
      double threshold = 0.;
    };

    /** The bound of a normal component, which is at least, for a negative sign
     * at most, this value; none if the sign is zero. */
    struct Bound
    {
      double sign  = 0.;
      double value = 0.;

      bool
      is_beyond(const double v_n) const
      {
        return sign * (v_n - value) < 0.;
      }
    };

    /** The minimiser without a bound. */
    static Tensor<1, n_components>
    minimise_unbounded(const Term                           &term,
                       const Tensor<2, n_components>        &A,
                       const Tensor<1, n_components>        &r,
                       const std::array<bool, n_components> &active,
                       const Tensor<1, n_components>        &start);

    /** The second derivative, of which the @p slope of the law is one part. */
    static Tensor<2, n_components>
    hessian_with(const Term                    &term,
                 const Tensor<1, n_components> &v,
                 const double                   slope);

    const std::vector<unsigned int>                       node_indices;
    const std::vector<double>                             weights;
    const std::vector<std::shared_ptr<const FrictionLaw>> laws;

    std::vector<Term> terms;
    /** One for each term, or none at all if no node may open. */
    std::vector<Bound> bounds;
    bool               has_openings = false;
  };
} // namespace StickSlip

#endif
