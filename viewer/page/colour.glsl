// The colour of a number: a place in the map, grey where there is none; a body without the field is plain.
uniform sampler2D colours;
uniform vec2 range;
uniform vec4 plain;
uniform bool only;

vec3 colour(float number) {
  if (plain.a > 0.5) return plain.rgb;
  if (number > 1e37) {
    if (only) discard;
    return vec3(0.62);
  }
  float width = range.y - range.x;
  // Half a step of the 16 bits lies within the range.
  float slack = 1e-5 * width;
  if (only && (number < range.x - slack || number > range.y + slack)) discard;
  float share = width > 0.0 ? (number - range.x) / width : 0.5;
  return texture(colours, vec2(clamp(share, 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
}

// Two lights, one beside the viewer and one from above; colours stay near those of the map.
vec3 lit(vec3 base, vec3 normal) {
  float main = max(dot(normal, normalize(vec3(-0.35, 0.45, 0.82))), 0.0);
  float fill = max(dot(normal, normalize(vec3(0.7, -0.2, 0.6))), 0.0);
  float shine = pow(max(dot(normal, normalize(vec3(-0.17, 0.22, 0.95))), 0.0), 40.0);
  return base * (0.46 + 0.5 * main + 0.14 * fill) + 0.06 * shine;
}
