package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Element;
import org.xml.sax.InputSource;

class XmlTextTest {

    private static Element read(String xml) throws Exception {
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new InputSource(new StringReader(xml)))
                .getDocumentElement();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "a",
                " two  words ",
                "\t",
                "line\nline",
                "line\rline",
                "line\r\nline",
                "\"'<&>]]>",
                "&#13;",
                "é😀"
            })
    void anAttributeIsReadAsItWasWritten(String text) throws Exception {
        assertEquals(
                text, read("<a b=\"" + XmlText.escapeAttribute(text) + "\"/>").getAttribute("b"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a", " two  words ", "\t", "line\nline", "\"'<&>]]>", "&#13;", "é😀"})
    void aTextIsReadAsItWasWritten(String text) throws Exception {
        assertEquals(text, read("<a>" + XmlText.escapeText(text) + "</a>").getTextContent());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 8, 0xB, 0xC, 0xE, 0x1F, 0xD800, 0xDFFF, 0xFFFE, 0xFFFF})
    void whatXmlCannotHoldBecomesAQuestionMark(int character) {
        assertEquals("a?b", XmlText.escapeText("a" + (char) character + "b"));
        assertFalse(XmlText.isValid("a" + (char) character + "b"));
    }

    @ParameterizedTest
    @ValueSource(ints = {0x9, 0xA, 0xD, 0x20, 0x7F, 0xD7FF, 0xE000, 0xFFFD, 0x10000, 0x10FFFF})
    void whatXmlCanHoldStays(int character) {
        String text = Character.toString(character);
        assertEquals(text, XmlText.escapeText(text));
        assertTrue(XmlText.isValid(text));
    }

    @ParameterizedTest
    @CsvSource({"'', ''", "' a', a", "'a\t', a", "'\n a b \r', a b", "'   ', ''", "'\u00A0a', '\u00A0a'"})
    void onlyTheWhiteSpaceOfXmlAroundATextIsRemoved(String text, String stripped) {
        assertEquals(stripped, XmlText.strip(text));
    }

    @Test
    void aTextInTheMiddleStays() {
        assertEquals("a \t b", XmlText.strip("a \t b"));
    }
}
