/**
 * External controllers, which use the protocol "faultline-lines 1": JSON messages, one per line, over the standard
 * streams of a child process, or over the program's own streams with reversed roles. All messages are exchanged in
 * lock-step, so a trajectory never depends on the speed of the other side. A time-out ends a run and never changes its
 * results.
 */
package faultline.external;
