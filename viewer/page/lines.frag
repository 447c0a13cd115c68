uniform vec4 ink;
out vec4 drawn;

void main() {
  drawn = ink;
}
