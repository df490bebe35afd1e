/**
 * The front doors: the command line, and the way to the window. Each command reads its arguments, calls the floors
 * below, and tells its outcome as lines and an exit code; nothing here ends the process but {@link faultline.app.Main}.
 */
package faultline.app;
