in vec3 side;
in vec3 at;
in float number;
uniform bool flatly;
uniform float veil;
out vec4 drawn;

void main() {
  vec3 base = colour(number);
  // Where no normal was given the face has that of its plane.
  vec3 normal = dot(side, side) > 0.1 ? normalize(side) : normalize(cross(dFdx(at), dFdy(at)));
  if (normal.z < 0.0) normal = -normal;
  drawn = vec4(flatly ? base : lit(base, normal), veil);
}
