/**
 * The flat look of the window, light and dark: Metal with a theme, a table of defaults and a small delegate for each
 * control that Metal draws differently; and icons that are drawn, not loaded. Event dispatch thread only. Nothing here
 * knows what a simulation is, but for the palette of the canvas that belongs to each theme.
 */
package faultline.gui.theme;
