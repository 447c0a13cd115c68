in vec3 place;
in float value;
in float size;
uniform mat4 see;
uniform float pixels;
uniform float grown;
out float number;
#ifdef SPHERES
uniform float deep;
out float reach;
#endif

void main() {
  gl_Position = see * vec4(place, 1.0);
  gl_PointSize = clamp(size * pixels * grown, 1.5, 256.0);
  number = value;
#ifdef SPHERES
  reach = 0.5 * size * grown * deep;
#endif
}
