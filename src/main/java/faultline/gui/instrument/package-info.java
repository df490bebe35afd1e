/**
 * The instruments: state diagram, alignment manoeuvre, strip charts and event log. Each one shows frames on the event
 * dispatch thread and reads their recordings. All can be painted without a display, and none knows the session.
 */
package faultline.gui.instrument;
