// The text of `cca-can help`.
#pragma once

namespace cca_can {

inline constexpr const char* help_text = R"(cca-can: CAN buses and the drives on them, by hand

  cca-can list                              the CAN interfaces: state, bit rate, counters
  cca-can list BUS [--ask FAMILIES]         drives that report by themselves, or answer
      --ask mit,moteus,robstride,cia402     asks these families, with frames that can't move a motor
      --ids FIRST-LAST                      which numbers to ask (1-16)
      --listen S                            how long to listen first (0.5)
  cca-can watch BUS DRIVE... [--ask] [--seconds S]
                                            what drives report, twice a second; --ask: asks as list does
  cca-can enable BUS DRIVE [--seconds S]    enables at the present position, disables at the end (*)
  cca-can jog BUS DRIVE --to R | --by R     moves one drive to the angle R in rad, or by R (*)
      --range LOW,HIGH                      rad; it never leaves this range
      --speed V --torque T                  rad/s, N m; never more
      --stiffness K --damping D             N m/rad (torque / 0.1 rad), N m s/rad (a fifth of torque / speed)
      --hold S                              how long at the end (0.5)
  cca-can calibrate BUS DRIVE --joint NAME --at R --file FILE (*)
                                            the joint is at R rad: its offset goes into FILE, which a controller loads
      --gear G --sign 1|-1 --offset R       as in the joint's mounting (1, 1, 0)
      --node PATH                           path of the synchronizer (robot.synchronizer)
  cca-can record BUS [--file FILE] [--seconds S] [--frames N]
                                            writes as `candump -L`, until ctrl-c
  cca-can replay BUS FILE [--from NAME] [--speed X | --fast] (*)
                                            sends a log again; NAME: only frames of this interface in it
  cca-can pretend BUS DRIVE... [--seconds S]
                                            plays drives, to try the rest without a robot (* unless BUS is a vcan)
      --silent-at S --silent-for S          makes them silent, for good or for S seconds
      --fault-at S --code N                 makes them report a fault, with the firmware's number N
      --load NM                             N m on each motor

(*) asks first; --yes confirms beforehand. `cca-can COMMAND --help` has the options of one command; --version.
BUS `memory` is a bus in this program, for machines without CAN: --pretend DRIVE, once or more often, says which
drives are played on it (without it those that the command names).
DRIVE: mit:ak80-9:3 (ak10-9, ak60-6, ak70-10, ak80-6, ak80-9, ak80-64, or ranges of position/velocity/torque as
       mit:12.5/45/20:3), damiao:12.5/45/20:3, mit-original:12.5/45/18:3; mit:ak80-9:3@16 answers under the id 16;
       odrive:3, odrive-0.5:3, moteus:KP/KD:3, robstride:rs04:3 (rs01, cybergear, or ranges of position/velocity/torque/
       stiffness/damping; @HOST if it does not answer to 253), cia402:COUNTS/RATED_TORQUE:3 (cyclic position), cia402-torque:... (torque)
@FILE stands for the words in FILE, where # begins a comment. BUS with `,fd`: CAN FD, as in can0,fd.
Ends with 0: done. 1: a drive or the bus failed; what was enabled has been disabled. 2: command line. 3: file or interface.
4: not confirmed. 130: ended by ctrl-c, disabled.
)";

}  // namespace cca_can
