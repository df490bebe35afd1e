/**
 * The preferences that persist between sessions: window bounds, text size, theme and recent files, in
 * {@link java.util.prefs}. Event dispatch thread only.
 */
package faultline.gui.settings;
