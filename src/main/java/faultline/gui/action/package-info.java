/** The actions of the user, shared by menu, tool bar and keyboard. Event dispatch thread only. */
package faultline.gui.action;
