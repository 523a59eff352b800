#!/bin/sh
# cca-can on vcan0, beside can-utils. Runs in the guest (CMakeLists.txt), where all programs are in this folder.
failures=0
is() {  # what, expected, got
  if [ "$2" = "$3" ]; then echo "ok: $1"; else failures=$((failures + 1)); printf 'FAILED: %s\nexpected: %s\ngot: %s\n' "$1" "$2" "$3"; fi
}
has() {  # what, expected part, text
  case $3 in *"$2"*) echo "ok: $1" ;; *) is "$1" "... $2 ..." "$3" ;; esac
}
ends() {  # what, code, command...
  what=$1 code=$2
  shift 2
  said=$("$@" 2>&1 </dev/null)
  is "$what ends with $code" "$code" $?
  printf '$ %s\n%s\n' "$*" "$said"
}
# The tool keeps only the bit rate flag of an FD frame.
frames() { cut -d ' ' -f 3 "$1" | sed 's/##[02468ACE]/##0/; s/##[13579BDF]/##1/'; }
PATH=/test:$PATH

ends "list of interfaces" 0 cca-can list
has "the interface with its kind" "vcan0  up  vcan  FD  received" "$said"
ends "an interface that is not there" 3 cca-can list can9
has "and the interfaces that are there" "there is no interface \`can9\`; those with CAN: vcan0" "$said"
ends "nobody answers" 1 cca-can list vcan0 --ask mit --ids 1-4

cca-can pretend vcan0 damiao:12.5/45/20:3 & player=$!
sleep 0.3
ends "a drive answers" 0 cca-can list vcan0 --ask mit --ids 1-4
has "and is named" "mit:3  answers 000#03" "$said"
ends "what it reports" 0 cca-can watch vcan0 damiao:12.5/45/20:3 --ask --seconds 0.5
has "its angle" "rad" "$said"
ends "nobody confirmed" 4 cca-can jog vcan0 damiao:12.5/45/20:3 --range -0.2,0.2 --speed 0.5 --torque 0.5 --by 0.1
ends "jog" 0 cca-can jog vcan0 damiao:12.5/45/20:3 --range -0.2,0.2 --speed 0.5 --torque 0.5 --by 0.1 --yes
has "and is off afterwards" "disabled" "$said"
kill $player  # a motor without torque coasts; the next one stands still
cca-can pretend vcan0 damiao:12.5/45/20:3 & player=$!
sleep 0.3
ends "calibrate" 0 cca-can calibrate vcan0 damiao:12.5/45/20:3 --joint left_hind_hip --at 0.3 --file /tmp/offsets.toml --yes
cat /tmp/offsets.toml
cca-can enable vcan0 damiao:12.5/45/20:3 --yes >/tmp/enabled 2>&1 & enabled=$!
sleep 0.5
kill -INT $enabled
wait $enabled
is "ctrl-c ends enable" 0 $?
has "and disables" "disabled" "$(cat /tmp/enabled)"
kill $player
wait $player

# By torque, and over FD.
cca-can pretend vcan0 odrive:5 cia402-torque:4096/0.8:9 moteus:20/0.8:4 & player=$!
sleep 0.3
ends "others answer" 0 cca-can list vcan0 --ask moteus,cia402 --ids 1-9
has "an ODrive by itself" "odrive:5  " "$said"
has "a CANopen drive" "cia402:9  answers 589#4300100092010200" "$said"
has "a moteus" "moteus:4  answers 400##1" "$said"
for drive in odrive:5 cia402-torque:4096/0.8:9 moteus:20/0.8:4; do
  ends "jog $drive" 0 cca-can jog vcan0 $drive --range -0.2,0.2 --speed 0.5 --torque 0.5 --by 0.1 --yes
done
ends "another mode" 1 cca-can enable vcan0 cia402:4096/0.8:9 --seconds 0.1 --yes
has "is reported" "configured for mode 10 (6061h), and its name says 8" "$said"
kill $player
wait $player

# The same traffic by candump and by cca-can.
candump -L vcan0 >/tmp/candump.log & dumper=$!
cca-can record vcan0,fd --file /tmp/ours.log --frames 104 2>/dev/null & recorder=$!
sleep 0.3
for frame in 044#2A366C2BBA 00000F6E# 7FF#R 123##1112233445566778899AABBCC 1FFFFFFF##0DE; do cansend vcan0 $frame; done
cangen vcan0 -n 99 -g 1 -m
wait $recorder
sleep 0.2
kill $dumper
wait $dumper
is "candump has all" 104 "$(grep -c . /tmp/candump.log)"
is "record writes what candump writes" "$(frames /tmp/candump.log)" "$(frames /tmp/ours.log)"
grep -q '^([0-9]\{10\}\.[0-9]\{6\}) vcan0 044#2A366C2BBA$' /tmp/ours.log
is "a line as candump has it" 0 $?

# Replayed: candump's log by cca-can, ours by canplayer.
cca-can record vcan0,fd --file /tmp/replayed.log --frames 104 2>/dev/null & recorder=$!
sleep 0.3
ends "replay of candump's log" 0 cca-can replay vcan0 /tmp/candump.log --fast --yes
wait $recorder
is "gives the same frames" "$(frames /tmp/candump.log)" "$(frames /tmp/replayed.log)"
cca-can record vcan0,fd --file /tmp/played.log --frames 104 2>/dev/null & recorder=$!
sleep 0.3
canplayer -I /tmp/ours.log -g 0
wait $recorder
is "canplayer plays ours" "$(frames /tmp/candump.log)" "$(frames /tmp/played.log)"

echo "$failures failures"
[ $failures = 0 ]
