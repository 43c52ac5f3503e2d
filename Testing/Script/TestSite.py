# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the site that are not Sphinx's: reading headers, placing links, finding those that lead nowhere."""
import os
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Documentation/site"))
import check  # noqa: E402
import gallery  # noqa: E402
import headers  # noqa: E402
import proxies  # noqa: E402
import python_api  # noqa: E402
import sources  # noqa: E402

CLASS = """
public:
  static vtkSample* New();
  ///@{
  /** Width in metres.
   * - thin
   */
  vtkSetClampMacro(Width, double, 0.5, 2);
  vtkGetMacro(Width, double);
  ///@}
  /** Says so. */
  virtual bool IsWide() const override { return this->Width > 1; }
  void Undocumented();

private:
  /** Not for others. */
  void Hide();
"""


class Headers(unittest.TestCase):
    def test_members(self):
        self.assertEqual(headers.Members(CLASS).found, [
            ("Width in metres.\n- thin\n\nSetWidth limits its value to 0.5 ... 2.", ["void SetWidth(double value)", "double GetWidth()"]),
            ("Says so.", ["bool IsWide() const"]), ("Not for others.", [])])

    def test_every_class_has_a_page_with_methods(self):
        made = headers.files()
        for path in headers.paths():
            page = made[f"api/vtk/{path.stem}.rst"]
            self.assertIn(".. cpp:function::", page, path)
            for name in re.findall(r"`\w+ <\w+::(\w+)>`", page):
                self.assertRegex(page, rf"(?m)(cpp:function::|^ {{18}}).*\b{name}\(", path)

    def test_enumerations_are_shown_with_their_methods(self):
        self.assertEqual(headers.member("Why.", ["enum A { B, C }", "void SetA(int a)", "int GetA()"], set()),
                         ".. cpp:function:: void SetA(int a)\n                  int GetA()\n\n   .. code-block:: cpp\n\n      enum A { B, C }\n\n   Why.\n")

    def test_lists_and_preformatted_text(self):
        text = headers.paragraphs("One:\n- a_b\n  more\nTwo of vtkHaze.\n    x = y", {"vtkHaze"})
        self.assertEqual(text, "One:\n\n- a\\_b\n  more\n\nTwo of :cpp:class:`vtkHaze`.\n\n::\n\n    x = y")


class Gallery(unittest.TestCase):
    def test_every_figure_has_picture_script_and_command(self):
        made = gallery.files()
        for figure in gallery.figures():
            page = made[f"gallery/{figure.stem}.md"]
            self.assertIn("](pictures/", page, figure)
            self.assertIn(f"./nephoscope demo {figure.stem[:2]}\n", page)
            self.assertEqual(made[f"gallery/scripts/{figure.stem}.py"], figure.read_text(encoding="utf-8"))

    def test_pictures_that_were_rendered_come_first(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(gallery, "RENDERED", pathlib.Path(folder)):
            figure = TOP / "Figures/03_winds_and_clouds.py"
            self.assertEqual([path.name for path in gallery.pictures(figure)], ["winds-and-clouds.jpg"])
            rendered = pathlib.Path(folder, "03_winds_and_clouds.png")
            rendered.touch()
            self.assertEqual(gallery.pictures(figure), [rendered])


class Reference(unittest.TestCase):
    def test_every_function_is_on_one_page(self):
        pages = "".join(text for name, text in python_api.files().items() if name != "api/python.rst")
        for name in python_api.functions():
            self.assertEqual(pages.count(f"autofunction:: nephoscope.{name}\n"), 1, name)

    def test_templates_are_filled_as_by_cmake(self):
        build = pathlib.Path(os.environ["NEPHOSCOPE_TEST_LIBRARIES"]).parent / "Plugins/ParaView"
        if not (build / "Representations.xml").is_file():
            self.skipTest("a build without ParaView")
        known = proxies.make_help.proxies([*sorted(proxies.PLUGIN.glob("*.xml")), *(build / f"{name}.xml" for name in ("FlowVolume", "Globe", "Smoothing", "Representations"))])
        made = proxies.make_help.proxies(proxies.definitions())
        self.assertEqual(list(made), list(known))
        for name, proxy in made.items():
            self.assertEqual(proxies.page("", proxy), proxies.page("", known[name]), name)


class Links(unittest.TestCase):
    def site(self, **pages):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name, text in pages.items():
            (folder / f"{name}.html").write_text(text, encoding="utf-8")
        return list(check.problems(folder))

    def test_what_leads_nowhere_is_found(self):
        self.assertEqual(self.site(a='<p id="here"><a href="b.html#there">x</a><a href="#here">x</a>', b='<p id="there">'), [])
        self.assertEqual(self.site(a='<a href="c.html">x</a>'), ["a.html: there is no c.html"])
        self.assertEqual(self.site(a='<a href="#there">x</a>'), ["a.html: there is no place #there"])

    def test_nothing_is_loaded_from_elsewhere(self):
        self.assertEqual(self.site(a='<a href="https://example.org/">x</a>'), [])
        self.assertEqual(self.site(a='<script src="https://example.org/x.js"></script>'), ["a.html: it loads https://example.org/x.js"])

    def placed(self, page, link):
        site = sources.Site(pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())))
        return sources.LINK.sub(lambda match: site.place(page, match), link), site.problems

    def test_links_are_placed(self):
        for page, link, expected in (
                ("README.md", "[a](Documentation/haze.md#limits)", "[a](Documentation/haze.md#limits)"),
                ("README.md", "[a](Documentation/images/haze.jpg)", "[a](gallery/17_haze.md)"),
                ("README.md", "![a](Documentation/images/haze.jpg)", "![a](Documentation/images/haze.jpg)"),
                ("Documentation/site/index.md", "[a](../haze.md)", "[a](Documentation/haze.md)"),
                ("Documentation/haze.md", "[a](../Representations/Haze/)", "[a](../Representations/Haze/README.md)"),
                ("Documentation/haze.md", "[a](../Testing/Cxx)", "a")):
            self.assertEqual(self.placed(page, link), (expected, []))
        self.assertEqual(self.placed("README.md", "[a](Nowhere.md)")[1], ["README.md: there is no Nowhere.md"])

    def test_names_lead_to_the_reference(self):
        site = sources.Site(pathlib.Path("unused"))
        self.assertEqual(site.with_reference("`add_haze`, `vtkHaze` and `vtkObject`"),
                         "{py:func}`add_haze <nephoscope.add_haze>`, {cpp:class}`vtkHaze` and `vtkObject`")
        self.assertEqual(site.with_reference("# `vtkHaze`"), "# `vtkHaze`")
        self.assertEqual(site.with_reference("``vtkHaze`` [`vtkHaze`](a.md)"), "``vtkHaze`` [`vtkHaze`](a.md)")


if __name__ == "__main__":
    unittest.main()
