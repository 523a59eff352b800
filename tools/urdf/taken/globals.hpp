// What the headers of C, POSIX and the engine declare outside of every namespace, so that no namespace can
// have that name. Inside of a robot's namespace its own names hide them.
//
// From both compilers: the words X after all headers of cca and of POSIX for which `namespace X {}` is
// refused.
#pragma once

#include <array>
#include <algorithm>
#include <string_view>

#include "macros.hpp"

namespace cca_urdf {

inline bool is_global(std::string_view word) {
  static constexpr std::array<std::string_view, 7> ends{"64", "64x", "32", "32x", "_unlocked", "_np", "_t"};
  static constexpr std::array<std::string_view, 4> beginnings{"pthread_", "wcs", "if", "sigev_"};
  static constexpr std::string_view others = R"(
cca std
ACTION ENTER ENTRY FILE FIND F_OWNER_GID F_OWNER_PGRP F_OWNER_PID F_OWNER_TID P_ALL P_PGID P_PID P_PIDFD
SCM_CAN_RAW_ERRQUEUE SKNLGRP_INET6_TCP_DESTROY SKNLGRP_INET6_UDP_DESTROY SKNLGRP_INET_TCP_DESTROY
SKNLGRP_INET_UDP_DESTROY SKNLGRP_NONE SK_DIAG_BPF_STORAGE SK_DIAG_BPF_STORAGE_MAP_ID
SK_DIAG_BPF_STORAGE_MAP_VALUE SK_DIAG_BPF_STORAGE_NONE SK_DIAG_BPF_STORAGE_PAD SK_DIAG_BPF_STORAGE_REP_NONE
SK_DIAG_BPF_STORAGE_REQ_MAP_FD SK_DIAG_BPF_STORAGE_REQ_NONE SK_MEMINFO_BACKLOG SK_MEMINFO_DROPS
SK_MEMINFO_FWD_ALLOC SK_MEMINFO_OPTMEM SK_MEMINFO_RCVBUF SK_MEMINFO_RMEM_ALLOC SK_MEMINFO_SNDBUF
SK_MEMINFO_VARS SK_MEMINFO_WMEM_ALLOC SK_MEMINFO_WMEM_QUEUED TRIMESH_FACE_NORMALS VISIT a64l abort accept
accept4 access acct acosf acoshf acoshl acosl adjtime alarm aligned_alloc alloca arc4random arc4random_buf
arc4random_uniform arpd_request arphdr arpreq arpreq_old asctime asctime_r asinf asinhf asinhl asinl asprintf
at_quick_exit atan2f atan2l atanf atanhf atanhl atanl atexit atof atoi atol atoll bcmp bcopy bind
bind_textdomain_codeset bindtextdomain brk bsearch btowc bzero calloc can_filter can_frame canfd_frame
canonicalize canonicalize_file_name canonicalizef canonicalizel canxl_frame cbrtf cbrtl ceilf ceill chdir
chmod chown chroot clearenv clearerr clock clock_adjtime clock_getcpuclockid clock_getres clock_gettime
clock_nanosleep clock_settime clone close close_range closefrom cmsghdr confstr connect copy_file_range
copysignf copysignl cosf coshf coshl cosl creat crypt ctermid ctime ctime_r cuserid d_ERR_IASSERT d_ERR_LCP
d_ERR_UASSERT d_ERR_UNKNOWN daddl daemon daylight dcgettext dcngettext ddiffint ddivl dfmal dgettext difftime
dint16 dint8 dintptr dmull dngettext dprintf drand48 drand48_data drand48_r drem dremf dreml dsizeint dsqrtl
dsubl duint16 duint8 duintptr dup dup2 dup3 duplocale dxBody dxCallReleasee dxCallWait dxCooperative dxGeom
dxHeightfieldData dxJoint dxJointGroup dxMutexGroup dxResourceContainer dxResourceRequirements dxSpace
dxThreadedWaitTime dxThreadingFunctionsInfo dxThreadingImplementation dxThreadingThreadPool dxTriMeshData
dxWorld dysize eaccess ecvt ecvt_r endorder endusershell entry environ erand48 erand48_r erfcf erfcl erff
erfl euidaccess execl execle execlp execv execve execveat execvp execvpe exit exp10 exp10f exp10l exp2f exp2l
expf expl explicit_bzero expm1f expm1l f_owner_ex fabsf fabsl faccessat fadd faddl fallocate fchdir fchmod
fchmodat fchown fchownat fclose fcloseall fcntl fcvt fcvt_r fd_mask fd_set fdatasync fdimf fdiml fdiv fdivl
fdopen feof ferror fexecve fflush ffma ffmal ffs ffsl ffsll fgetc fgetpos fgets fgetwc fgetws file_handle
fileno finite finitef finitel flock flockfile floorf floorl fmaf fmal fmaxf fmaximum fmaximum_mag
fmaximum_mag_num fmaximum_mag_numf fmaximum_mag_numl fmaximum_magf fmaximum_magl fmaximum_num fmaximum_numf
fmaximum_numl fmaximumf fmaximuml fmaxl fmaxmag fmaxmagf fmaxmagl fmemopen fminf fminimum fminimum_mag
fminimum_mag_num fminimum_mag_numf fminimum_mag_numl fminimum_magf fminimum_magl fminimum_num fminimum_numf
fminimum_numl fminimumf fminimuml fminl fminmag fminmagf fminmagl fmodf fmodl fmul fmull fopen fopencookie
fork fpathconf fprintf fputc fputs fputwc fputws fread free freelocale freopen frexpf frexpl fromfp fromfpf
fromfpl fromfpx fromfpxf fromfpxl fscanf fseek fseeko fsetpos fsqrt fsqrtl fstat fstatat fsub fsubl fsync
ftell ftello ftruncate ftrylockfile funlockfile futex_waitv futimens futimes futimesat fwide fwprintf fwrite
fwscanf gamma gammaf gammal gcvt get_current_dir_name getc getchar getcpu getcwd getdate getdate_err
getdate_r getdelim getdomainname getdtablesize getegid getentropy getenv geteuid getgid getgroups gethostid
gethostname getitimer getline getloadavg getlogin getlogin_r getopt getpagesize getpass getpayload
getpayloadf getpayloadl getpeername getpgid getpgrp getpid getppid getpriority getpt getresgid getresuid
getrlimit getrusage getsid getsockname getsockopt getsubopt gettext gettid gettimeofday getuid getumask
getusershell getw getwc getwchar getwd gmtime gmtime_r grantpt group_member gsignal hcreate hcreate_r
hdestroy hdestroy_r hsearch hsearch_data hsearch_r hypotf hypotl ilogbf ilogbl index initstate initstate_r
insque ioctl iovec isalnum isalnum_l isalpha isalpha_l isascii isatty isblank isblank_l iscntrl iscntrl_l
isctype isdigit isdigit_l isfdtype isgraph isgraph_l isinff isinfl islower islower_l isnanf isnanl isprint
isprint_l ispunct ispunct_l isspace isspace_l isupper isupper_l iswalnum iswalnum_l iswalpha iswalpha_l
iswblank iswblank_l iswcntrl iswcntrl_l iswctype iswctype_l iswdigit iswdigit_l iswgraph iswgraph_l iswlower
iswlower_l iswprint iswprint_l iswpunct iswpunct_l iswspace iswspace_l iswupper iswupper_l iswxdigit
iswxdigit_l isxdigit isxdigit_l itimerspec itimerval j0 j0f j0l j1 j1f j1l jmp_buf jn jnf jnl jrand48
jrand48_r kill killpg l64a labs lchmod lchown lcong48 lcong48_r lconv ldexpf ldexpl ldiv leaf lfind lgamma_r
lgammaf lgammaf32_r lgammaf32x_r lgammaf64_r lgammaf64x_r lgammaf_r lgammal lgammal_r linger link linkat
listen llabs lldiv llogb llogbf llogbl llrintf llrintl llroundf llroundl localeconv localtime localtime_r
lockf log10f log10l log1pf log1pl log2f log2l logbf logbl logf logl longjmp lrand48 lrand48_r lrintf lrintl
lroundf lroundl lsearch lseek lstat lutimes madvise malloc mblen mbrlen mbrtowc mbsinit mbsnrtowcs mbsrtowcs
mbstowcs mbtowc memccpy memcmp memcpy memfd_create memfrob memmem memmove mempcpy memset mincore mkdir
mkdirat mkdtemp mkfifo mkfifoat mknod mknodat mkostemp mkostemps mkstemp mkstemps mktemp mktime mlock mlock2
mlockall mmap mmsghdr modff modfl mprotect mrand48 mrand48_r mremap msghdr msync munlock munlockall munmap
name_to_handle_at nan nanf nanl nanosleep nearbyintf nearbyintl newlocale nextafterf nextafterl nextdown
nextdownf nextdownl nexttowardf nexttowardl nextup nextupf nextupl ngettext nice nrand48 nrand48_r obstack
obstack_printf obstack_vprintf on_exit open open_by_handle_at open_memstream open_wmemstream openat optarg
opterr optind optopt osockaddr pathconf pause pclose perror pipe pipe2 pkey_alloc pkey_free pkey_get
pkey_mprotect pkey_set popen posix_fadvise posix_fallocate posix_madvise posix_memalign posix_openpt
postorder powf powl pread preadv preadv2 preadv64v2 preorder printf prlimit process_madvise process_mrelease
process_vm_readv process_vm_writev profil program_invocation_name program_invocation_short_name pselect
psiginfo psignal ptsname ptsname_r putc putchar putenv puts putw putwc putwchar pwrite pwritev pwritev2
pwritev64v2 qecvt qecvt_r qelem qfcvt qfcvt_r qgcvt qsort qsort_r quick_exit raise rand rand_r random
random_data random_r read readahead readlink readlinkat readv realloc reallocarray realpath recv recvfrom
recvmmsg recvmsg remainderf remainderl remap_file_pages remove remque remquof remquol rename renameat
renameat2 revoke rewind rindex rintf rintl rlimit rmdir robust_list robust_list_head roundeven roundevenf
roundevenl roundf roundl rpmatch rusage sbrk scalb scalbf scalbl scalblnf scalblnl scalbnf scalbnl scanf
sched_get_priority_max sched_get_priority_min sched_getaffinity sched_getcpu sched_getparam
sched_getscheduler sched_param sched_rr_get_interval sched_setaffinity sched_setparam sched_setscheduler
sched_yield secure_getenv seed48 seed48_r select sem_clockwait sem_close sem_destroy sem_getvalue sem_init
sem_open sem_post sem_timedwait sem_trywait sem_unlink sem_wait send sendmmsg sendmsg sendto setbuf setbuffer
setdomainname setegid setenv seteuid setgid sethostid sethostname setitimer setjmp setlinebuf setlocale
setlogin setns setpayload setpayloadf setpayloadl setpayloadsig setpayloadsigf setpayloadsigl setpgid setpgrp
setpriority setregid setresgid setresuid setreuid setrlimit setsid setsockopt setstate setstate_r
settimeofday setuid setusershell setvbuf shm_open shm_unlink shutdown sigaction sigaddset sigaltstack
sigandset sigblock sigcontext sigdelset sigemptyset sigevent sigfillset siggetmask sighold sigignore
siginterrupt sigisemptyset sigismember sigjmp_buf siglongjmp signal signgam significand significandf
significandl sigorset sigpause sigpending sigprocmask sigqueue sigrelse sigreturn sigset sigsetmask sigstack
sigsuspend sigtimedwait sigval sigwait sigwaitinfo sincos sincosf sincosl sinf sinhf sinhl sinl
sknetlink_groups sleep snprintf sock_diag_req sockaddr sockaddr_can sockaddr_storage sockatmark socket
socketpair splice sprintf sqrtf sqrtl srand srand48 srand48_r srandom srandom_r sscanf ssignal stat statx
statx_timestamp stpcpy stpncpy strcasecmp strcasecmp_l strcat strcmp strcoll strcoll_l strcpy strcspn strdup
strerror strerror_l strerror_r strfromd strfromf strfroml strfry strftime strftime_l strlen strncasecmp
strncasecmp_l strncat strncmp strncpy strndup strnlen strptime strptime_l strsep strsignal strspn strtod
strtod_l strtof strtof32_l strtof32x_l strtof64_l strtof64x_l strtof_l strtok strtok_r strtol strtol_l
strtold strtold_l strtoll strtoll_l strtoq strtoul strtoul_l strtoull strtoull_l strtouq strverscmp strxfrm
strxfrm_l swab swprintf swscanf symlink symlinkat sync sync_file_range syncfs syscall sysconf system
sysv_signal tanf tanhf tanhl tanl tcgetpgrp tcsetpgrp tdelete tdestroy tee tempnam termio textdomain tfind
tgammaf tgammal tgkill time timegm timelocal timer_create timer_delete timer_getoverrun timer_gettime
timer_settime timespec timespec_get timespec_getres timeval timex timezone tm tmpfile tmpnam tmpnam_r toascii
tolower tolower_l totalorder totalorderf totalorderl totalordermag totalordermagf totalordermagl toupper
toupper_l towctrans towctrans_l towlower towlower_l towupper towupper_l truncate truncf truncl tsearch
ttyname ttyname_r ttyslot twalk twalk_r tzname tzset u_char u_int u_long u_short ualarm ucred ufromfp
ufromfpf ufromfpl ufromfpx ufromfpxf ufromfpxl uint ulong umask ungetc ungetwc unlink unlinkat unlockpt
unsetenv unshare uselocale ushort usleep utimensat utimes va_list valloc vasprintf vdprintf vfork vfprintf
vfscanf vfwprintf vfwscanf vhangup vmsplice vprintf vscanf vsnprintf vsprintf vsscanf vswprintf vswscanf
vwprintf vwscanf wait wait3 wait4 waitid waitpid wcpcpy wcpncpy wcrtomb wctob wctomb wctrans wctrans_l wctype
wctype_l wcwidth winsize wmemchr wmemcmp wmemcpy wmemmove wmempcpy wmemset wprintf write writev wscanf y0 y0f
y0l y1 y1f y1l yn ynf ynl
)";
  const bool is_of_engine = word.size() > 1 && word[0] == 'd' && word[1] >= 'A' && word[1] <= 'Z';
  return is_of_engine || std::ranges::any_of(ends, [&](std::string_view e) { return word.ends_with(e); }) ||
         std::ranges::any_of(beginnings, [&](std::string_view b) { return word.starts_with(b); }) ||
         is_macro(word) || detail::is_among(word, others);
}

}  // namespace cca_urdf
