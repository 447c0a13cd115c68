in vec3 place;
uniform mat4 see;
uniform float nearer;

void main() {
  gl_Position = see * vec4(place, 1.0);
  gl_Position.z -= nearer;
}
