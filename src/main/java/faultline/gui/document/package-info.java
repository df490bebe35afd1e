/**
 * The scenario that is open, the run that is made of it, and what of it is changed. Event dispatch thread only,
 * asserted; files are read and written, and sessions made, in the background.
 */
package faultline.gui.document;
