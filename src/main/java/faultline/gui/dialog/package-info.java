/**
 * The dialogs of the window: questions, progress, the guide and the about box. Event dispatch thread only, asserted.
 */
package faultline.gui.dialog;
