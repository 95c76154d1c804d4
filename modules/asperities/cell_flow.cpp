#include "asperities/cell_flow.hpp"

#include <algorithm>
#include <array>

#include "asperities/aggregation.hpp"

namespace ehl::asperities {
namespace {

constexpr double flow_tolerance = 1e-8;
constexpr int most_iterations = 500;

// The cell seen along the flow: `length` points along it, `width` across. Gaps are in units of h.
struct Channel {
  int length = 0, width = 0;
  std::size_t step_along = 0, step_across = 0;
  double along = 0.0, across = 0.0;  // factors of the conductances: width of a face over the distance of the points
  const std::vector<double>* gap = nullptr;
  double h = 1.0;

  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(i) * step_along + static_cast<std::size_t>(j) * step_across;
  }
  // Beyond the edges the cell is mirrored.
  double g(int i, int j) const {
    const int inside_i = std::clamp(i, 0, length - 1), inside_j = std::clamp(j, 0, width - 1);
    return (*gap)[at(inside_i, inside_j)] / h;
  }
};

// Resistance over length of a gap that varies linearly.
double resistance(double g1, double g2) { return (g1 + g2) / (2.0 * g1 * g1 * g2 * g2); }

// Conductance, times the length, between the points 1 and 2 of four in a row.
double conductance(double g0, double g1, double g2, double g3) {
  const double cubic = (9.0 * (g1 + g2) - g0 - g3) / 16.0;
  const double middle = g0 > 0.0 && g3 > 0.0 && cubic > 0.0 ? cubic : 0.5 * (g1 + g2);
  return 2.0 / (resistance(g1, middle) + resistance(middle, g2));
}

Channel channel_of(const Cell& cell, const std::vector<double>& gap, double h, FlowAlong direction) {
  const auto nx = static_cast<std::size_t>(cell.nx);
  if (direction == FlowAlong::x) return {cell.nx, cell.ny, 1, nx, cell.dy / cell.dx, cell.dx / cell.dy, &gap, h};
  return {cell.ny, cell.nx, nx, 1, cell.dx / cell.dy, cell.dy / cell.dx, &gap, h};
}

// Marks the open points that a way connects with the edge i = from.
std::vector<char> reached_from(const Channel& channel, int from) {
  std::vector<char> reached(channel.gap->size(), 0);
  std::vector<std::array<int, 2>> front;
  const auto visit = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= channel.length || j >= channel.width || !(channel.g(i, j) > 0.0)) return;
    char& mark = reached[channel.at(i, j)];
    if (mark == 0) front.push_back({i, j});
    mark = 1;
  };
  for (int j = 0; j < channel.width; ++j) visit(from, j);
  while (!front.empty()) {
    const auto [i, j] = front.back();
    front.pop_back();
    visit(i - 1, j);
    visit(i + 1, j);
    visit(i, j - 1);
    visit(i, j + 1);
  }
  return reached;
}

// The number of each point that lies on a way from edge to edge; -1: it does not.
std::vector<int> numbers_of(const Channel& channel, int& count) {
  const std::vector<char> from_inlet = reached_from(channel, 0),
                          from_outlet = reached_from(channel, channel.length - 1);
  std::vector<int> number(from_inlet.size(), -1);
  count = 0;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (from_inlet[n] != 0 && from_outlet[n] != 0) number[n] = count++;
  return number;
}

// From the last point to the edge it is half a distance.
double to_edge(const Channel& channel, int i, int j) {
  const double g = channel.g(i, j);
  return 2.0 * channel.along * g * g * g;
}

Network network_of(const Channel& channel, const std::vector<int>& number, int count, std::vector<double>& b) {
  struct Place {
    int i, j;
  };
  std::vector<Place> places(static_cast<std::size_t>(count));
  for (int i = 0; i < channel.length; ++i)
    for (int j = 0; j < channel.width; ++j)
      if (const int n = number[channel.at(i, j)]; n >= 0) places[static_cast<std::size_t>(n)] = {i, j};
  Network network;
  network.first.push_back(0);
  b.assign(static_cast<std::size_t>(count), 0.0);
  for (std::size_t n = 0; n < places.size(); ++n) {
    const auto [i, j] = places[n];
    const double g = channel.g(i, j);
    double diagonal = 0.0;
    const auto connect = [&, i = i, j = j](int di, int dj, double factor) {
      const int i2 = i + di, j2 = j + dj;
      if (i2 < 0 || j2 < 0 || i2 >= channel.length || j2 >= channel.width) return;
      const int other = number[channel.at(i2, j2)];
      if (other < 0) return;
      const double c =
          factor * conductance(channel.g(i - di, j - dj), g, channel.g(i2, j2), channel.g(i2 + di, j2 + dj));
      network.column.push_back(other);
      network.conductance.push_back(c);
      diagonal += c;
    };
    connect(-1, 0, channel.along);
    connect(1, 0, channel.along);
    connect(0, -1, channel.across);
    connect(0, 1, channel.across);
    if (i == 0) b[n] = to_edge(channel, i, j);
    if (i == 0 || i + 1 == channel.length) diagonal += to_edge(channel, i, j);
    network.diagonal.push_back(diagonal);
    network.first.push_back(network.column.size());
  }
  return network;
}

}  // namespace

CellFlow flow_through(const Cell& cell, const std::vector<double>& gap, double h, FlowAlong along) {
  if (!(h > 0.0)) return {};
  const Channel channel = channel_of(cell, gap, h, along);
  int count = 0;
  const std::vector<int> number = numbers_of(channel, count);
  if (count == 0) return {};
  std::vector<double> b;
  const Network network = network_of(channel, number, count, b);
  const NetworkSolution solution = solve(network, b, flow_tolerance, most_iterations);
  double flow = 0.0;  // through the inlet
  for (int j = 0; j < channel.width; ++j)
    if (const int n = number[channel.at(0, j)]; n >= 0)
      flow += to_edge(channel, 0, j) * (1.0 - solution.x[static_cast<std::size_t>(n)]);
  const double smooth = channel.along * channel.width / channel.length;
  return {flow / smooth, solution.residual, solution.iterations};
}

}  // namespace ehl::asperities
