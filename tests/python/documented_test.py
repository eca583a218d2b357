"""What holds the page to its word notices a broken one."""

import documented
from cases import Case

PAGE = """# A page

```python
>>> x = 2
>>> x + 1
3
>>> for k in range(2):
...     print(k)
0
1
>>> [][0]
IndexError: list index out of range
```
"""


class Documented(Case):
    def test_a_page_that_is_right_passes(self):
        new, complaints = documented.run(PAGE)
        self.assertEqual((new, complaints), (PAGE, []))

    def test_one_that_is_wrong_does_not(self):
        for right, wrong in (("\n3\n", "\n4\n"), ("0\n1\n", "0\n"), ("\n3\n", "\n"), ("IndexError: list", "KeyError: list")):
            self.assertIn(right, PAGE)
            new, complaints = documented.run(PAGE.replace(right, wrong))
            self.assertEqual(len(complaints), 1)
            self.assertEqual(new, PAGE)

    def test_a_page_without_examples_is_noticed(self):
        path = self.folder / "page.md"
        path.write_text("# Nothing\n")
        self.assertIn("no examples", documented.main(path))
