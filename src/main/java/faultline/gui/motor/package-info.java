/**
 * The faults of the motors of a run: the section of the control panel that lists and repairs them, and the dialog that
 * adds one. Uses the controls of the control panel; knows neither the time line nor the window. Event dispatch thread
 * only.
 */
package faultline.gui.motor;
