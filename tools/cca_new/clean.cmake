# After refusals no project, and no half of one, is in `work`.
file(GLOB left LIST_DIRECTORIES true ${work}/my_robot ${work}/.my_robot.* ${work}/time)
if(left)
  message(FATAL_ERROR "left behind: ${left}")
endif()
