// What `cca-can help` says.
#pragma once

namespace cca_can {

inline constexpr const char* help_text = R"(cca-can: CAN buses and the drives on them, by hand

  cca-can list                              the CAN interfaces: state, bit rate, counters
  cca-can list BUS [--ask FAMILIES]         drives that tell of themselves, or answer
      --ask mit,moteus,cia402               asks these families, by frames that can't move a motor
      --ids FIRST-LAST                      which numbers to ask (1-16)
      --listen S                            how long to listen first (0.5)
  cca-can watch BUS DRIVE... [--ask] [--seconds S]
                                            what drives tell, twice a second; --ask: as list asks
  cca-can enable BUS DRIVE [--seconds S]    enabled where it stands, disabled at the end (*)
  cca-can jog BUS DRIVE --to R | --by R     one joint to an angle of the drive, in rad, or by so much (*)
      --range LOW,HIGH                      rad; it never leaves it
      --speed V --torque T                  rad/s, N m; never more
      --stiffness K --damping D             N m/rad (torque / 0.1 rad), N m s/rad (a fifth of torque / speed)
      --hold S                              how long at the end (0.5)
  cca-can calibrate BUS DRIVE --joint NAME --at R --file FILE (*)
                                            the joint stands at R rad: its offset goes into FILE, which a controller loads
      --gear G --sign 1|-1 --offset R       as in the joint's mounting (1, 1, 0)
      --node PATH                           of the synchronizer (robot.synchronizer)
  cca-can record BUS [--file FILE] [--seconds S] [--frames N]
                                            as `candump -L` writes, until ctrl-c
  cca-can replay BUS FILE [--from NAME] [--speed X | --fast] (*)
                                            a log goes out again; NAME: frames of this interface in it
  cca-can pretend BUS DRIVE... [--seconds S]
                                            plays drives, for trying the rest without a robot (* unless BUS is a vcan)
      --silent-at S --silent-for S          troubles on demand: they say nothing, for good or so long
      --fault-at S --code N                 and a fault, by the firmware's number of it
      --load NM                             N m on each motor

(*) asks first; --yes says yes beforehand.
DRIVE: mit:ak80-9:3 (ak10-9, ak60-6, ak70-10, ak80-6, ak80-9, ak80-64, or ranges of position/velocity/torque as
       mit:12.5/45/20:3), damiao:12.5/45/20:3, mit-original:12.5/45/18:3; mit:ak80-9:3@16 answers under the id 16;
       odrive:3, odrive-0.5:3, moteus:KP/KD:3, cia402:COUNTS/RATED_TORQUE:3 (cyclic position), cia402-torque:... (torque)
@FILE stands for the words in FILE, where # begins a comment. BUS with `,fd`: CAN FD, as in can0,fd.
Ends with 0: done. 1: a drive or the bus failed; what was enabled has been disabled. 2: command line. 3: file or interface.
4: not confirmed. 130: ended by ctrl-c, disabled.
)";

}  // namespace cca_can
