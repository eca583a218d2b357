#include "proofs/prover/gram_centre.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

namespace delcert {

namespace {

using DenseMatrix = Eigen::MatrixXd;
using DenseVector = Eigen::VectorXd;
using DenseIndex = Eigen::Index;

DenseMatrix dense_matrix(const std::vector<double>& rows, std::size_t order) {
  const auto n = static_cast<DenseIndex>(order);
  DenseMatrix result(n, n);
  for (DenseIndex i = 0; i < n; ++i) {
    for (DenseIndex j = 0; j < n; ++j) result(i, j) = rows[static_cast<std::size_t>(i * n + j)];
  }
  return result;
}

/// Minimises t/μ − Σ log det(block(y) + t·1) for smaller and smaller μ by Newton's method.
class CentralPath {
 public:
  explicit CentralPath(const std::vector<GramBlock>& blocks) {
    for (const GramBlock& block : blocks) {
      BlockPart part{dense_matrix(block.base, block.order), {}};
      for (const auto& direction : block.directions) part.directions.push_back(dense_matrix(direction, block.order));
      parts_.push_back(std::move(part));
    }
    count_ = static_cast<DenseIndex>(parts_.empty() ? 0 : parts_.front().directions.size());
    y_ = DenseVector::Zero(count_);
    for (const BlockPart& part : parts_) scale_ = std::max(scale_, part.base.cwiseAbs().maxCoeff());
    t_ = std::max(0.0, -least_eigenvalue()) + scale_;
    bound_the_traces();
  }

  ApproximateCentre run() {
    ApproximateCentre result;
    double least_before = 0;
    for (double mu = std::max(scale_, t_); mu > 1e-10 * scale_; mu *= 0.2) {
      if (!centre(mu)) break;
      const double least = least_eigenvalue();
      constexpr double well_inside = 1e-5;
      if (least > well_inside * scale_ && least < 1.3 * least_before) break;
      least_before = least;
    }
    constexpr double outside = 1e-4;
    const double least = least_eigenvalue();
    result.is_found = std::isfinite(least) && least > -outside * scale_;
    result.is_inside = result.is_found && least > 1e-6 * scale_;
    result.y.assign(y_.data(), y_.data() + count_);
    if (result.is_found && !result.is_inside) result.null_vectors = null_vectors();
    return result;
  }

 private:
  struct BlockPart {
    DenseMatrix base;
    std::vector<DenseMatrix> directions;
  };

  [[nodiscard]] DenseMatrix at(const BlockPart& part, const DenseVector& y) const {
    DenseMatrix result = part.base;
    for (DenseIndex i = 0; i < count_; ++i) result += y(i) * part.directions[static_cast<std::size_t>(i)];
    return result;
  }

  /// With two constraints that add up to 0, as those of an equation do, matrices of the family have no bound.
  void bound_the_traces() {
    constexpr double far = 1000;
    double most = far * (scale_ + t_);
    DenseMatrix base = DenseMatrix::Zero(1, 1);
    std::vector<double> slopes(static_cast<std::size_t>(count_), 0.0);
    for (const BlockPart& part : parts_) {
      most += far * scale_ * static_cast<double>(part.base.rows());
      base(0, 0) -= part.base.trace();
      for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] -= part.directions[i].trace();
    }
    base(0, 0) += most;
    bound_.base = base;
    for (const double slope : slopes) bound_.directions.emplace_back(DenseMatrix::Constant(1, 1, slope));
  }

  [[nodiscard]] double least_eigenvalue() const {
    double result = HUGE_VAL;
    for (const BlockPart& part : parts_) {
      const Eigen::SelfAdjointEigenSolver<DenseMatrix> solver(at(part, y_), Eigen::EigenvaluesOnly);
      result = std::min(result, solver.eigenvalues()(0));
    }
    return result;
  }

  [[nodiscard]] bool is_inside(const DenseVector& y, double t) const {
    const auto is_inside_of = [&](const BlockPart& part) {
      const DenseMatrix shifted = at(part, y) + t * DenseMatrix::Identity(part.base.rows(), part.base.cols());
      return Eigen::LLT<DenseMatrix>(shifted).info() == Eigen::Success;
    };
    return is_inside_of(bound_) && std::all_of(parts_.begin(), parts_.end(), is_inside_of);
  }

  bool centre(double mu) {
    constexpr int most_steps = 40;
    for (int step = 0; step < most_steps; ++step) {
      DenseVector gradient = DenseVector::Zero(count_ + 1);
      DenseMatrix hessian = DenseMatrix::Zero(count_ + 1, count_ + 1);
      gradient(count_) = 1 / mu;
      for (const BlockPart& part : parts_) add(part, gradient, hessian);
      add(bound_, gradient, hessian);
      hessian.diagonal().array() *= 1 + 1e-12;
      const DenseVector move = -hessian.ldlt().solve(gradient);
      const double decrement = std::sqrt(std::max(0.0, -gradient.dot(move)));
      if (!std::isfinite(decrement)) return false;
      double length = decrement > 0.25 ? 1 / (1 + decrement) : 1;
      while (length > 1e-12 && !is_inside(y_ + length * move.head(count_), t_ + length * move(count_))) length /= 2;
      y_ += length * move.head(count_);
      t_ += length * move(count_);
      if (decrement < 1e-6) break;
    }
    return std::isfinite(t_);
  }

  void add(const BlockPart& part, DenseVector& gradient, DenseMatrix& hessian) const {
    const DenseIndex order = part.base.rows();
    const DenseMatrix shifted = at(part, y_) + t_ * DenseMatrix::Identity(order, order);
    const DenseMatrix inverse = shifted.llt().solve(DenseMatrix::Identity(order, order));
    std::vector<DenseMatrix> images;
    for (const DenseMatrix& direction : part.directions) images.emplace_back(inverse * direction);
    images.push_back(inverse);
    for (DenseIndex i = 0; i <= count_; ++i) {
      const DenseMatrix& here = images[static_cast<std::size_t>(i)];
      gradient(i) -= here.trace();
      for (DenseIndex j = 0; j <= i; ++j) {
        const double entry = here.cwiseProduct(images[static_cast<std::size_t>(j)].transpose()).sum();
        hessian(i, j) += entry;
        if (i != j) hessian(j, i) += entry;
      }
    }
  }

  [[nodiscard]] std::vector<std::vector<std::vector<double>>> null_vectors() const {
    double greatest = 0;
    std::vector<Eigen::SelfAdjointEigenSolver<DenseMatrix>> solvers;
    for (const BlockPart& part : parts_) {
      solvers.emplace_back(at(part, y_));
      greatest = std::max(greatest, solvers.back().eigenvalues().tail(1)(0));
    }
    constexpr double small = 1e-4;
    std::vector<std::vector<std::vector<double>>> result;
    for (const auto& solver : solvers) {
      result.emplace_back();
      for (DenseIndex i = 0; i < solver.eigenvalues().size() && solver.eigenvalues()(i) < small * greatest; ++i) {
        const DenseVector vector = solver.eigenvectors().col(i);
        result.back().emplace_back(vector.data(), vector.data() + vector.size());
      }
    }
    return result;
  }

  std::vector<BlockPart> parts_;
  BlockPart bound_;  ///< a number that is positive while the sum of all traces has not become large
  DenseIndex count_ = 0;
  DenseVector y_;
  double t_ = 0;
  double scale_ = 1e-3;
};

}  // namespace

ApproximateCentre approximate_centre(const std::vector<GramBlock>& blocks) { return CentralPath(blocks).run(); }

}  // namespace delcert
