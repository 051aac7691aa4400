// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/convert_face.cpp - OpenCASCADE's faces as plain data
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "spigolo/cad/occt-inl.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

// A trimming curve becomes chords that stray from it by this share of the face's range at most.
constexpr double chord_tolerance = 1e-6;
constexpr int first_pieces = 16, most_halvings = 10;
// A trimming curve this close to the rectangle's border lies on it.
constexpr double on_border = 1e-6;

ParamPoint to_plain(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }

struct Scale {
  double u = 1, v = 1;

  double deviation(const ParamPoint& a, const ParamPoint& b, const ParamPoint& middle) const {
    return std::max(std::abs((a.u + b.u) / 2 - middle.u) / u,
                    std::abs((a.v + b.v) / 2 - middle.v) / v);
  }
};

void refine(const Handle(Geom2d_Curve) & curve, const Interval& range, int halvings,
            const Scale& scale, TrimCurve& out) {
  const double middle = range.at(0.5);
  const ParamPoint a = to_plain(curve->Value(range.begin)), m = to_plain(curve->Value(middle)),
                   b = to_plain(curve->Value(range.end));
  if (halvings == 0 || scale.deviation(a, b, m) <= chord_tolerance) {
    out.push_back(b);
    return;
  }
  refine(curve, {range.begin, middle}, halvings - 1, scale, out);
  refine(curve, {middle, range.end}, halvings - 1, scale, out);
}

TrimCurve chords(const Handle(Geom2d_Curve) & curve, const Interval& range, const Scale& scale) {
  TrimCurve out = {to_plain(curve->Value(range.begin))};
  for (int i = 0; i < first_pieces; ++i)
    refine(curve, {range.at(double(i) / first_pieces), range.at(double(i + 1) / first_pieces)},
           most_halvings, scale, out);
  return out;
}

std::vector<TrimCurve> trimming_curves(const TopoDS_Face& face) {
  double u0, u1, v0, v1;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const Scale scale{std::max(u1 - u0, 1e-12), std::max(v1 - v0, 1e-12)};
  std::vector<TrimCurve> curves;
  const TopoDS_Shape forward = face.Oriented(TopAbs_FORWARD);
  for (TopExp_Explorer edges(forward, TopAbs_EDGE); edges.More(); edges.Next()) {
    double begin = 0, end = 0;
    const Handle(Geom2d_Curve) curve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(edges.Current()), TopoDS::Face(forward), begin, end);
    if (!curve.IsNull()) curves.push_back(chords(curve, {begin, end}, scale));
  }
  return curves;
}

bool lies_on(const Interval& range, double value) {
  const double slack = on_border * range.length();
  return std::abs(value - range.begin) <= slack || std::abs(value - range.end) <= slack;
}

// Whether all of the curve runs along one side of the rectangle.
bool along_border(const TrimCurve& curve, const Interval& u, const Interval& v) {
  const auto on_u = [&](const ParamPoint& p) { return lies_on(u, p.u); };
  const auto on_v = [&](const ParamPoint& p) { return lies_on(v, p.v); };
  return std::all_of(curve.begin(), curve.end(), on_u) ||
         std::all_of(curve.begin(), curve.end(), on_v);
}

std::vector<double> flat_knots(const TColStd_Array1OfReal& sequence) {
  return {sequence.begin(), sequence.end()};
}

NurbsSurface plain_surface(Handle(Geom_BSplineSurface) surface) {
  NurbsSurface s;
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  if (surface->IsUPeriodic()) s.period_u = u1 - u0;
  if (surface->IsVPeriodic()) s.period_v = v1 - v0;
  surface->SetUNotPeriodic();
  surface->SetVNotPeriodic();
  s.degree_u = surface->UDegree();
  s.degree_v = surface->VDegree();
  s.poles_u = static_cast<std::size_t>(surface->NbUPoles());
  s.poles_v = static_cast<std::size_t>(surface->NbVPoles());
  s.knots_u = flat_knots(surface->UKnotSequence());
  s.knots_v = flat_knots(surface->VKnotSequence());
  const bool rational = surface->IsURational() || surface->IsVRational();
  for (int i = 1; i <= surface->NbUPoles(); ++i)
    for (int j = 1; j <= surface->NbVPoles(); ++j) {
      s.poles.push_back(from_occt(surface->Pole(i, j)));
      if (rational) s.weights.push_back(surface->Weight(i, j));
    }
  return s;
}

// Reference parts of GeomConvert: a rectangle cut out of a larger surface is no B-spline yet.
Handle(Geom_BSplineSurface) b_spline_of(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) return GeomConvert::SurfaceToBSplineSurface(surface);
  return Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
}

}  // namespace

FaceRange range_of(const TopoDS_Face& face) {
  FaceRange range;
  range.trims = trimming_curves(face);
  range.u = range.v = {infinity, -infinity};
  for (const TrimCurve& curve : range.trims)
    for (const ParamPoint& p : curve) {
      range.u = {std::min(range.u.begin, p.u), std::max(range.u.end, p.u)};
      range.v = {std::min(range.v.begin, p.v), std::max(range.v.end, p.v)};
    }
  const bool full =
      std::all_of(range.trims.begin(), range.trims.end(),
                  [&](const TrimCurve& curve) { return along_border(curve, range.u, range.v); });
  if (full) range.trims.clear();
  return range;
}

NurbsFace convert_face(const TopoDS_Face& face) {
  try {
    BRepBuilderAPI_NurbsConvert converter(face, true);
    const TopoDS_Face converted = TopoDS::Face(converter.Shape());
    NurbsFace out;
    out.surface = plain_surface(b_spline_of(converted));
    out.reversed = converted.Orientation() == TopAbs_REVERSED;
    FaceRange range = range_of(converted);
    out.u = range.u;
    out.v = range.v;
    out.trims = std::move(range.trims);
    validate(out);
    find_seams(out);
    return out;
  } catch (const Standard_Failure& failure) {
    throw NoResultError("this face cannot be made a NURBS surface: " + message_of(failure));
  } catch (const Error& error) {
    throw NoResultError(std::string("this face cannot be made a NURBS surface: ") + error.what());
  }
}

}  // namespace spigolo
