/**
 * Edits of the scenario: named edits that can be undone, the commands that have no effect in a frame yet, and the
 * shapes of new obstacles. {@link faultline.gui.edit.CommandSender} sends commands through a channel, which returns
 * their results, and {@link faultline.gui.edit.UndoController} records these. Event dispatch thread only. Does not
 * depend on the window and the canvas.
 */
package faultline.gui.edit;
