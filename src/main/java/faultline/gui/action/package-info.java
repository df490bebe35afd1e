/** What the user can do: one action for each thing, shared by menu, tool bar and key. Event dispatch thread only. */
package faultline.gui.action;
