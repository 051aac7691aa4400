// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/to_occt.cpp
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>

#include "spigolo/cad/occt-inl.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr double edge_tolerance = 1e-6;  // [units of the file] as CAD programs have it

// Distinct knots with their multiplicities.
struct KnotList {
  std::vector<double> knots;
  std::vector<int> multiplicities;

  explicit KnotList(const std::vector<double>& flat) {
    for (const double t : flat) {
      if (knots.empty() || t > knots.back()) {
        knots.push_back(t);
        multiplicities.push_back(0);
      }
      ++multiplicities.back();
    }
  }
  TColStd_Array1OfReal values() const {
    TColStd_Array1OfReal array(1, static_cast<int>(knots.size()));
    for (std::size_t i = 0; i < knots.size(); ++i) array(static_cast<int>(i) + 1) = knots[i];
    return array;
  }
  TColStd_Array1OfInteger counts() const {
    TColStd_Array1OfInteger array(1, static_cast<int>(knots.size()));
    for (std::size_t i = 0; i < knots.size(); ++i)
      array(static_cast<int>(i) + 1) = multiplicities[i];
    return array;
  }
};

gp_Ax2 axes(const Vec3& origin, const Vec3& z, const Vec3& x) {
  return {to_occt(origin), gp_Dir(z.x, z.y, z.z), gp_Dir(x.x, x.y, x.z)};
}

TopoDS_Shape checked(BRepBuilderAPI_MakeShape& maker, bool done, const char* what) {
  if (!done) throw Error(std::string(what) + " is degenerate: it has no length or no area");
  return maker.Shape();
}

struct EdgeMaker {
  TopoDS_Shape operator()(const CadLine& line) const {
    BRepBuilderAPI_MakeEdge maker(to_occt(line.a), to_occt(line.b));
    return checked(maker, maker.IsDone(), "a line");
  }
  TopoDS_Shape operator()(const CadArc& arc) const {
    if (!(arc.radius > 0)) throw Error("an arc's radius is not positive");
    const Handle(Geom_Circle) circle =
        new Geom_Circle(axes(arc.center, cross(arc.x, arc.y), arc.x), arc.radius);
    BRepBuilderAPI_MakeEdge maker(circle, arc.begin, arc.end);
    return checked(maker, maker.IsDone(), "an arc");
  }
  TopoDS_Shape operator()(const NurbsCurve& curve) const {
    BRepBuilderAPI_MakeEdge maker(to_occt(curve));
    return checked(maker, maker.IsDone(), "a curve");
  }
};

// A closed polygon of parameters as edges on the surface.
TopoDS_Wire wire_of(const TrimCurve& loop, const Handle(Geom_Surface) & surface) {
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ParamPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const gp_Vec2d way(b.u - a.u, b.v - a.v);
    const Handle(Geom2d_Line) line = new Geom2d_Line({a.u, a.v}, gp_Dir2d(way));
    BRepBuilderAPI_MakeEdge edge(line, surface, 0, way.Magnitude());
    if (edge.IsDone()) wire.Add(edge.Edge());
  }
  if (!wire.IsDone()) throw Error("a trimming loop does not close");
  return wire.Wire();
}

Handle(Geom_Surface) surface_of(const CadFace& face) {
  if (const auto* nurbs = std::get_if<NurbsSurface>(&face.surface)) return to_occt(*nurbs);
  const auto& c = std::get<CadCylinder>(face.surface);
  return new Geom_CylindricalSurface(axes(c.origin, c.axis, c.x), c.radius);
}

TopoDS_Shape face_of(const CadFace& face) {
  const Handle(Geom_Surface) surface = surface_of(face);
  if (!face.loops.empty()) {
    BRepBuilderAPI_MakeFace maker(surface, wire_of(face.loops.front(), surface), true);
    for (std::size_t i = 1; i < face.loops.size(); ++i) maker.Add(wire_of(face.loops[i], surface));
    TopoDS_Shape shape = checked(maker, maker.IsDone(), "a face");
    BRepLib::BuildCurves3d(shape);
    return shape;
  }
  if (const auto* c = std::get_if<CadCylinder>(&face.surface)) {
    BRepBuilderAPI_MakeFace maker(surface, 0, 2 * pi, 0, c->height, edge_tolerance);
    return checked(maker, maker.IsDone(), "a cylinder");
  }
  BRepBuilderAPI_MakeFace maker(surface, edge_tolerance);
  return checked(maker, maker.IsDone(), "a face");
}

TopoDS_Compound empty_compound() {
  TopoDS_Compound compound;
  BRep_Builder().MakeCompound(compound);
  return compound;
}

void silence() {
  const Handle(Message_Messenger)& messenger = Message::DefaultMessenger();
  messenger->ChangePrinters().Clear();
}

}  // namespace

OcctSession::OcctSession() {
  static std::mutex one_at_a_time;
  lock_ = std::unique_lock(one_at_a_time);
  silence();
}

std::string message_of(const Standard_Failure& failure) {
  const std::string text = failure.GetMessageString();
  return text.empty() ? failure.DynamicType()->Name() : text;
}

Handle(Geom_BSplineCurve) to_occt(const NurbsCurve& curve) {
  validate(curve);
  const KnotList list(curve.knots);
  const int n = static_cast<int>(curve.poles.size());
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal weights(1, n);
  for (int i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    poles(i + 1) = to_occt(curve.poles[at]);
    weights(i + 1) = curve.weights.empty() ? 1.0 : curve.weights[at];
  }
  return new Geom_BSplineCurve(poles, weights, list.values(), list.counts(), curve.degree);
}

Handle(Geom_BSplineSurface) to_occt(const NurbsSurface& s) {
  validate(s);
  const KnotList u(s.knots_u), v(s.knots_v);
  const int nu = static_cast<int>(s.poles_u), nv = static_cast<int>(s.poles_v);
  TColgp_Array2OfPnt poles(1, nu, 1, nv);
  TColStd_Array2OfReal weights(1, nu, 1, nv);
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const auto at = static_cast<std::size_t>(i) * s.poles_v + static_cast<std::size_t>(j);
      poles(i + 1, j + 1) = to_occt(s.poles[at]);
      weights(i + 1, j + 1) = s.weights.empty() ? 1.0 : s.weights[at];
    }
  return new Geom_BSplineSurface(poles, weights, u.values(), v.values(), u.counts(), v.counts(),
                                 s.degree_u, s.degree_v);
}

TopoDS_Shape faces_to_occt(const StepContent& content) {
  TopoDS_Compound compound = empty_compound();
  for (const CadFace& face : content.faces) BRep_Builder().Add(compound, face_of(face));
  return compound;
}

TopoDS_Shape curves_to_occt(const StepContent& content) {
  TopoDS_Compound compound = empty_compound();
  for (const CadCurve& curve : content.curves)
    BRep_Builder().Add(compound, std::visit(EdgeMaker{}, curve));
  return compound;
}

TopoDS_Shape points_to_occt(const StepContent& content) {
  TopoDS_Compound compound = empty_compound();
  for (const Vec3& p : content.points)
    BRep_Builder().Add(compound, BRepBuilderAPI_MakeVertex(to_occt(p)).Vertex());
  return compound;
}

}  // namespace spigolo
