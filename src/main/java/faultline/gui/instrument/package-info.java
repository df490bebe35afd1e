/**
 * The controller seen: its state diagram, the t_D/2 manoeuvre, strip charts and the event log. Each instrument is shown
 * frames on the event dispatch thread and reads what the frames' recordings remember; none needs a display to be
 * painted, and none knows the session.
 */
package faultline.gui.instrument;
