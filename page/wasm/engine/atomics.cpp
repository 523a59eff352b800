// The engine customizes its atomics library when it starts. Here it has one thread and no atomics, so there
// is nothing to do.
class COdeOu {
public:
  static bool DoOUCustomizations();
  static void UndoOUCustomizations();
};
bool COdeOu::DoOUCustomizations() { return true; }
void COdeOu::UndoOUCustomizations() {}
