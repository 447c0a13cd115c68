in float number;
uniform bool flatly;
out vec4 drawn;
#ifdef SPHERES
in float reach;
#endif

void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  float off = dot(at, at);
  if (off > 1.0) discard;
#ifdef SPHERES
  // The surface of a sphere lies before the plane of its middle: spheres cut each other as they should.
  gl_FragDepth = gl_FragCoord.z - reach * sqrt(1.0 - off);
#endif
  vec3 base = colour(number);
  vec3 normal = vec3(at.x, -at.y, sqrt(1.0 - off));
  drawn = vec4(flatly ? base * (1.0 - 0.25 * off * off) : lit(base, normal), 1.0);
}
