// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/min_cut.cpp - largest flow by two trees that grow towards each other and are mended
// after each push (idea of Y. Boykov and V. Kolmogorov, 2004)
#include "spigolo/mesh/min_cut.h"

#include <algorithm>
#include <cstdlib>

namespace spigolo {

MinCut::MinCut(std::size_t nodes) : nodes_(nodes) {}

void MinCut::add_node_price(std::uint32_t node, std::int32_t of_0, std::int32_t of_1) {
  // label 1 cuts the arc from root 0, label 0 the one to root 1
  nodes_[node].terminal += of_1 - of_0;
}

void MinCut::add_edge_price(std::uint32_t a, std::uint32_t b, std::int32_t price) {
  const auto arc = static_cast<std::uint32_t>(arcs_.size());
  arcs_.push_back({b, nodes_[a].first, price});
  arcs_.push_back({a, nodes_[b].first, price});
  nodes_[a].first = arc, nodes_[b].first = arc + 1;
}

void MinCut::activate(std::uint32_t node) {
  if (nodes_[node].active) return;
  nodes_[node].active = true;
  queue_.push_back(node);
}

std::vector<std::uint8_t> MinCut::solve(const Job& job) {
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if (node.terminal == 0) continue;
    node.tree = node.terminal > 0 ? Tree::zero : Tree::one;
    node.parent = root, node.steps = 1;
    activate(i);
  }
  while (queue_head_ < queue_.size()) {
    job.check();
    const std::uint32_t node = queue_[queue_head_];
    const std::uint32_t arc = nodes_[node].tree == Tree::free ? none : grow(node);
    if (arc == none) {
      nodes_[node].active = false;
      ++queue_head_;
      continue;
    }
    ++round_;
    augment(arc);
    adopt();
  }
  std::vector<std::uint8_t> label(nodes_.size());
  for (std::size_t i = 0; i < label.size(); ++i) label[i] = nodes_[i].tree != Tree::zero;
  return label;
}

// Takes free neighbors into the tree of a node; stops at one of the other tree.
std::uint32_t MinCut::grow(std::uint32_t at) {
  const Node& node = nodes_[at];
  for (std::uint32_t arc = node.first; arc != none; arc = arcs_[arc].next) {
    // away from root 0, towards root 1
    if (left_from(arc ^ 1, node.tree) == 0) continue;
    Node& other = nodes_[arcs_[arc].head];
    if (other.tree == Tree::free) {
      other.tree = node.tree, other.parent = arc ^ 1;
      other.seen = node.seen, other.steps = node.steps + 1;
      activate(arcs_[arc].head);
    } else if (other.tree != node.tree) {
      return node.tree == Tree::zero ? arc : arc ^ 1;
    } else if (other.seen <= node.seen && other.steps > node.steps + 1) {
      other.parent = arc ^ 1;  // a shorter way
      other.seen = node.seen, other.steps = node.steps + 1;
    }
  }
  return none;
}

// From a node to the root of its tree: towards is true for tree 1.
std::int32_t MinCut::bottleneck(std::uint32_t node, bool towards) const {
  std::int32_t least = std::abs(nodes_[node].terminal);
  bool at_root = nodes_[node].parent == root;
  if (!at_root) least = INT32_MAX;
  while (!at_root) {
    const std::uint32_t arc = nodes_[node].parent;
    least = std::min(least, towards ? arcs_[arc].left : arcs_[arc ^ 1].left);
    node = arcs_[arc].head;
    at_root = nodes_[node].parent == root;
    if (at_root) least = std::min(least, std::abs(nodes_[node].terminal));
  }
  return least;
}

void MinCut::push(std::uint32_t node, bool towards, std::int32_t flow) {
  for (;;) {
    Node& here = nodes_[node];
    const std::uint32_t arc = here.parent;
    if (arc == root) {
      here.terminal += towards ? flow : -flow;
      if (here.terminal == 0) here.parent = orphan, orphans_.push_back(node);
      return;
    }
    const std::uint32_t forward = towards ? arc : arc ^ 1;
    arcs_[forward].left -= flow, arcs_[forward ^ 1].left += flow;
    if (arcs_[forward].left == 0) here.parent = orphan, orphans_.push_back(node);
    node = arcs_[arc].head;
  }
}

// Along an arc from tree 0 to tree 1.
void MinCut::augment(std::uint32_t arc) {
  const std::uint32_t from = arcs_[arc ^ 1].head, to = arcs_[arc].head;
  const std::int32_t flow =
      std::min({arcs_[arc].left, bottleneck(from, false), bottleneck(to, true)});
  arcs_[arc].left -= flow, arcs_[arc ^ 1].left += flow;
  push(from, false, flow);
  push(to, true, flow);
}

void MinCut::adopt() {
  for (std::size_t next = 0; next < orphans_.size(); ++next) find_parent(orphans_[next]);
  orphans_.clear();
}

// none if the way to the root is broken; marks the way otherwise.
std::uint32_t MinCut::steps_to_root(std::uint32_t at) {
  std::uint32_t steps = 0;
  for (std::uint32_t node = at;; node = arcs_[nodes_[node].parent].head) {
    const Node& here = nodes_[node];
    if (here.seen == round_) {
      steps += here.steps;
      break;
    }
    ++steps;
    if (here.parent == root) break;
    if (here.parent == orphan || here.parent == none) return none;
  }
  const std::uint32_t found = steps;
  for (std::uint32_t node = at; nodes_[node].seen != round_;
       node = arcs_[nodes_[node].parent].head) {
    nodes_[node].seen = round_, nodes_[node].steps = steps--;
    if (nodes_[node].parent == root) break;
  }
  return found;
}

void MinCut::find_parent(std::uint32_t at) {
  Node& node = nodes_[at];
  std::uint32_t best = none, fewest = none;
  for (std::uint32_t arc = node.first; arc != none; arc = arcs_[arc].next) {
    const Node& other = nodes_[arcs_[arc].head];
    if (other.tree != node.tree || other.parent == none || left_from(arc, node.tree) == 0) continue;
    const std::uint32_t steps = steps_to_root(arcs_[arc].head);
    if (steps < fewest) fewest = steps, best = arc;
  }
  if (best != none) {
    node.parent = best, node.seen = round_, node.steps = fewest + 1;
    return;
  }
  for (std::uint32_t arc = node.first; arc != none; arc = arcs_[arc].next) {
    const std::uint32_t head = arcs_[arc].head;
    Node& other = nodes_[head];
    if (other.tree != node.tree || other.parent == none) continue;
    if (left_from(arc, node.tree) > 0) activate(head);
    if (other.parent < orphan && arcs_[other.parent].head == at)
      other.parent = orphan, orphans_.push_back(head);
  }
  node.tree = Tree::free, node.parent = none;
}

}  // namespace spigolo
