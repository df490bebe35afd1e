/**
 * Controllers from outside the program, by the protocol "faultline-lines 1": JSON messages, one a line, over the
 * standard streams of a child process, or over the program's own streams with the roles turned. Everything is in
 * lock-step, so a trajectory never depends on how fast the other side is; time-outs end a run and never change one.
 */
package faultline.external;
