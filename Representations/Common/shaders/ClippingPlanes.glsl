// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the clipping planes of a mapper leave of a ray. CLIPPING_PLANES is their number.
uniform vec4 clippingPlanes[CLIPPING_PLANES]; // dot((p, 1), plane) >= 0 is seen, of points p in VC

// Least and greatest t of the points + t * direction that all planes let be seen; least > greatest: none.
vec2 clippedRay(vec3 point, vec3 direction)
{
  vec2 range = vec2(-3.0e38, 3.0e38);
  for (int i = 0; i < CLIPPING_PLANES; ++i)
  {
    float distance = dot(clippingPlanes[i], vec4(point, 1.0));
    float slope = dot(clippingPlanes[i].xyz, direction);
    if (slope > 0.0)
    {
      range.x = max(range.x, -distance / slope);
    }
    else if (slope < 0.0)
    {
      range.y = min(range.y, -distance / slope);
    }
    else if (distance < 0.0) // a ray along the plane, behind it
    {
      return vec2(3.0e38, -3.0e38);
    }
  }
  return range;
}
