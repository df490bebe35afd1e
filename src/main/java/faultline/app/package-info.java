/**
 * The command line, and the entry to the window. Each command parses its arguments, calls the packages below, and
 * reports its outcome as lines and an exit code. Only {@link faultline.app.Main} ends the process, or
 * {@link faultline.app.ExitGuard} if a controller does.
 */
package faultline.app;
