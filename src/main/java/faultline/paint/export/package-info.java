/**
 * Picture files made from frames: PNG and SVG images, animated GIFs and printed pages. Any thread may call it; nothing
 * here needs a display.
 */
package faultline.paint.export;
