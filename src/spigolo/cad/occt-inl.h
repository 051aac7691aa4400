// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/occt-inl.h - between our plain data and OpenCASCADE; inside this room only
#pragma once

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <mutex>
#include <string>

#include "spigolo/cad/step_writer.h"

namespace spigolo {

/// OpenCASCADE keeps its settings in globals and talks on standard output: whoever calls it holds
/// one of these, which lets one thread in at a time and has it silent.
class OcctSession {
 public:
  OcctSession();

 private:
  std::unique_lock<std::mutex> lock_;
};

/// The message of an exception of OpenCASCADE, never empty.
std::string message_of(const Standard_Failure& failure);

inline gp_Pnt to_occt(const Vec3& p) { return {p.x, p.y, p.z}; }
inline Vec3 from_occt(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

Handle(Geom_BSplineCurve) to_occt(const NurbsCurve& curve);
Handle(Geom_BSplineSurface) to_occt(const NurbsSurface& surface);

/// Each kind in one compound.
TopoDS_Shape faces_to_occt(const StepContent& content);
TopoDS_Shape curves_to_occt(const StepContent& content);
TopoDS_Shape points_to_occt(const StepContent& content);

/// Any face as NURBS data. Throws NoResultError if OpenCASCADE cannot convert it.
NurbsFace convert_face(const TopoDS_Face& face);

/// Whether the face is less than its rectangle of parameters, and that rectangle.
struct FaceRange {
  Interval u, v;
  std::vector<TrimCurve> trims;  // empty if it fills the rectangle
};
FaceRange range_of(const TopoDS_Face& face);

}  // namespace spigolo
