/**
 * The texts of the user interface by key, in English and in every language that has a properties file, and the numbers,
 * times and angles in them. Any thread gets texts; {@link faultline.gui.text.CachedDegrees} and the language are for
 * the event dispatch thread, which sets it. They know no component of the window, no document and no session.
 */
package faultline.gui.text;
