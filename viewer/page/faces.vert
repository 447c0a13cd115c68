in vec3 place;
in vec3 normal;
in float value;
uniform mat4 see;
uniform mat3 turn;
out vec3 side;
out vec3 at;
out float number;

void main() {
  gl_Position = see * vec4(place, 1.0);
  side = turn * normal;
  at = turn * place;
  number = value;
}
